// SPDX-License-Identifier: MIT
// shrink.c -- shortens a program after which worlds differ: drops calls, then sets arguments to their defaults.
//
// This work is based on: Andreas Zeller, Ralf Hildebrandt, Simplifying and Isolating Failure-Inducing Input, 2002.
#include "programs/program.h"
#include "tools/common/clock.h"
#include <math.h>
#include <string.h>

typedef struct
{
	Program* best;
	Program trial;
	Pair* pair;
	double end; // s, by seconds_now: limit of time
} Shrink;

static bool over(const Shrink* s) { return seconds_now() > s->end; }

// Runs the trial. If worlds differ after it, keeps it without the calls after the first difference, and returns true.
static bool keeps(Shrink* s)
{
	if (s->trial.count < 2)
		return false;
	Outcome outcome = pair_run(s->pair, &s->trial, NULL);
	if (!outcome.differs)
		return false;
	program_copy(s->best, &s->trial);
	if (outcome.call > 0)
		s->best->count = outcome.call + 1;
	return true;
}

static void drop_calls(Shrink* s)
{
	for (int part = s->best->count / 2; part >= 1 && !over(s); part /= 2)
		for (int first = s->best->count - part; first >= 1 && !over(s); first -= part)
		{
			// earlier trials may have made the program shorter than the end of this part
			if (first + part > s->best->count)
				continue;
			s->trial.count = 0;
			for (int k = 0; k < s->best->count; ++k)
				if (k < first || k >= first + part)
					program_add(&s->trial, s->best->calls[k]);
			keeps(s);
		}
}

static bool try_value(Shrink* s, int call, int argument, float value)
{
	float old = s->best->calls[call].value[argument];
	if (over(s) || memcmp(&old, &value, sizeof value) == 0)
		return false;
	program_copy(&s->trial, s->best);
	s->trial.calls[call].value[argument] = value;
	return keeps(s);
}

static void simplify(Shrink* s)
{
	for (int k = s->best->count - 1; k >= 0 && !over(s); --k)
	{
		if (k >= s->best->count)
			continue;
		const CallInfo* info = call_info(s->best->calls[k].kind);
		for (int i = 0; i < info->count && k < s->best->count; ++i)
		{
			float x = s->best->calls[k].value[i];
			bool count = strcmp(info->names[i], "count") == 0;
			if (memcmp(&x, &info->values[i], sizeof x) == 0)
				continue;
			if (try_value(s, k, i, info->values[i]) || try_value(s, k, i, 0.0f))
				continue;
			while (count && x > 1.0f && try_value(s, k, i, floorf(0.5f * x)))
				x = floorf(0.5f * x);
			if (!count && !try_value(s, k, i, x < 0.0f ? -1.0f : 1.0f) && !try_value(s, k, i, rintf(x)))
				try_value(s, k, i, rintf(8.0f * x) / 8.0f);
		}
	}
}

void program_shrink(Program* program, Pair* pair, double seconds)
{
	Shrink s = {.best = program, .pair = pair, .end = seconds_now() + seconds};
	for (int before = 0; before != program->count && !over(&s);)
	{
		before = program->count;
		drop_calls(&s);
	}
	simplify(&s);
	drop_calls(&s);
	program_close(&s.trial);
}
