// SPDX-License-Identifier: MIT
// mirrored.c -- runs a seed: hostile worlds in a batch, random calls, and a world alone for each of them.
#include "mirror/mirrored.h"
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ROUNDS 60 // number of rounds of calls of a seed

typedef struct
{
	int rarity; // the call is made in one of this number of rounds
	bool (*make)(Mirror* m);
} Choice;

// The calls of a round, in their order.
static const Choice choices[] = {
    {8, bind_inputs}, {10, bind_resets},  {10, bind_outputs}, {6, call_templates}, {4, call_reset},
    {5, call_pause},  {8, call_gravity},  {4, call_copy},     {8, call_bank},      {4, call_extract},
    {5, call_insert}, {40, batch_reopen}, {1, call_step},     {6, call_observe},
};

void note(Mirror* m, const char* format, ...)
{
	va_list values;
	m->call += 1;
	va_start(values, format);
	vsnprintf(m->made, sizeof m->made, format, values);
	va_end(values);
	if (m->setting.shows)
		printf("seed %" PRIu64 ", call %d: %s\n", m->seed, m->call, m->made);
}

bool fault(Mirror* m, const char* format, ...)
{
	va_list values;
	if (m->sentence[0])
		return false;
	va_start(values, format);
	vsnprintf(m->sentence, sizeof m->sentence, format, values);
	va_end(values);
	return false;
}

bool end_early(Mirror* m)
{
	m->ended = true;
	return false;
}

bool needed(Mirror* m, scree_status status, const char* call)
{
	return status == SCREE_OK || fault(m, "%s failed with status %d: %s", call, (int)status, scree_error());
}

static bool run_rounds(Mirror* m)
{
	for (int round = 0; round < ROUNDS; ++round)
		for (size_t k = 0; k < sizeof choices / sizeof *choices; ++k)
			if (one_in(&m->dice, choices[k].rarity) && !choices[k].make(m))
				return false;
	return true;
}

void mirror_run(const Setting* setting, uint64_t seed, Counts* counts)
{
	Mirror* m = calloc(1, sizeof *m);
	size_t before = scree_memory();
	m->setting = *setting;
	m->counts = counts;
	m->seed = m->dice = seed;
	bool whole = batch_open(m) && run_rounds(m);
	batch_close(m);
	if (whole && scree_memory() != before)
		fault(m, "%zu bytes of memory are left", scree_memory() - before);
	if (m->sentence[0])
		printf("seed %" PRIu64 ", call %d, %s: %s\n", seed, m->call, m->made, m->sentence);
	counts->seeds += 1;
	counts->ended += m->ended;
	counts->faults += m->sentence[0] != 0;
	fflush(stdout);
	free(m);
}
