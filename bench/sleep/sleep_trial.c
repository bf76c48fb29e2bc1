// SPDX-License-Identifier: MIT
// sleep_trial.c -- runs a world of a case once, and measures its steps.
//
// Nothing is read back between timed steps, so a GPU may begin a step before the last one has ended; the clock stops
// when the device has finished the last step. In cases that wake bodies, each step is waited for, because single steps
// are of interest.
#include "sleep_trial.h"
#include "sleep_worlds.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include "validate/scree_world.h"
#include <stdio.h>
#include <string.h>

// Steps before the clock starts: groups of sleeping bodies rest 8 to 16 steps after their last change, and the case
// `spawn` creates its bodies.
#define WARM_UP 40
// Timed steps of cases that wake bodies. Bodies at rest fall asleep again after 30 steps.
#define WAKE_STEPS 28

static bool take_step(SleepRun* run, int number, bool waits, double* ms)
{
	double begin = seconds_now();
	if ((run->item->act && !run->item->act(run, number)) || !sleep_run_step(run) ||
	    (waits && !report_status(scree_world_wait(run->world))))
		return false;
	*ms = 1e3 * (seconds_now() - begin);
	return true;
}

// Computes the results from the times of all steps, and sorts the times.
static void evaluate(SleepResult* result, double* ms, bool wakes)
{
	result->mean = 0.0;
	for (int k = 0; k < result->steps; ++k)
		result->mean += ms[k] / result->steps;
	if (wakes)
	{
		memcpy(result->first, ms, sizeof result->first);
		result->median = median_of(ms + FIRST_STEPS, result->steps - FIRST_STEPS);
		sort_values(ms, FIRST_STEPS);
		result->most = ms[FIRST_STEPS - 1];
	}
	else
	{
		result->median = median_of(ms, result->steps);
		result->most = ms[result->steps - 1];
	}
}

static bool measure(SleepRun* run, SleepResult* result)
{
	static double ms[MAX_STEPS];
	bool wakes = run->item->beside == BESIDE_LATER;
	result->steps = wakes ? WAKE_STEPS : run->setting->steps;
	for (int k = 0; k < WARM_UP; ++k)
	{
		if (!(wakes ? sleep_run_step(run) : take_step(run, k, k == WARM_UP - 1, &ms[0])))
			return false;
	}
	for (int k = 0; k < result->steps; ++k)
	{
		if (!take_step(run, wakes ? k : WARM_UP + k, wakes || k == result->steps - 1, &ms[k]))
			return false;
	}
	evaluate(result, ms, wakes);
	return report_status(scree_world_get_counters(run->world, &result->counters)) &&
	       report_status(scree_world_get_hash(run->world, &result->hash));
}

// Copies the name of a device, with blanks instead of commas, which would end a cell of the CSV.
static void copy_name(const char* name, char* copy, size_t size)
{
	snprintf(copy, size, "%s", name);
	for (; *copy; ++copy)
		*copy = *copy == ',' ? ' ' : *copy;
}

bool sleep_trial_run(const SleepCase* item, const SleepSetting* setting, bool compared, bool checked,
                     SleepResult* result)
{
	SleepRun run = {.item = item, .setting = setting, .compared = compared, .checked = checked};
	*result = (SleepResult){0};
	bool good = sleep_world_open(&run) && item->build(&run) && measure(&run, result);
	if (good)
	{
		copy_name(scree_world_get_device(run.world), result->device, sizeof result->device);
		result->threads = scree_world_get_threads(run.world);
		result->lanes = scree_world_get_lanes(run.world);
		result->penetration = run.penetration;
		result->frozen = run.frozen;
		result->asleep = run.asleep;
		result->found = run.found;
		result->expected = run.expected;
	}
	sleep_world_close(&run);
	return good;
}
