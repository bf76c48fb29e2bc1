// SPDX-License-Identifier: MIT
// sleep_rows.c -- measures a case of scree_sleep, checks that the work was done, and prints its rows.
//
// Each world runs once with counters that are read after each step, for the deepest overlap, and then some times
// without reads, for the times. All runs must end with the same hash, so the overlap is also that of the timed runs. If
// a case has two worlds, they take turns, and the ratio is the median of the ratios of two consecutive runs.
#include "sleep_rows.h"
#include "sleep_trial.h"
#include "tools/common/median.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

// Deepest overlap of a valid row, m. A pyramid of 100 rows has 0.018.
#define DEEPEST 0.05f

typedef struct
{
	const SleepCase* item;
	bool compared;
	SleepResult last;             // the last timed run
	double mean, median, most;    // medians of all timed runs, ms
	char ratio[16];               // empty if the case compares nothing
	char first[16 * FIRST_STEPS]; // ms of the first steps that wake bodies, with blanks between them
	float penetration;
	bool valid;
	double means[MAX_REPEATS], medians[MAX_REPEATS], longest[MAX_REPEATS], firsts[FIRST_STEPS][MAX_REPEATS];
} SleepRow;

static const char* world_name(const SleepRow* row)
{
	switch (row->item->beside)
	{
	case BESIDE_AWAKE:
		return row->compared ? "awake alone" : "with sleepers";
	case BESIDE_NO_SLEEP:
		return row->compared ? "never sleeps" : "may sleep";
	default:
		return "";
	}
}

static void complain(SleepRow* row, bool good, const char* what)
{
	if (good)
		return;
	row->valid = false;
	fprintf(stderr, "scree_sleep: %s%s%s is invalid: %s\n", row->item->name, *world_name(row) ? ", " : "",
	        world_name(row), what);
}

// Checks the state at the end of a run.
static void check_end(SleepRow* row, const SleepResult* result)
{
	complain(row, result->counters.asleep_bodies == result->asleep, "another number of bodies sleeps at the end");
	complain(row, result->found == result->expected, "rays or the sensor found something else");
}

static bool check(SleepRow* row, const SleepSetting* setting)
{
	SleepResult result;
	if (!sleep_trial_run(row->item, setting, row->compared, true, &result))
		return false;
	row->last.hash = result.hash;
	row->penetration = result.penetration;
	complain(row, result.frozen == 0, "bodies whose state was not finite were frozen");
	complain(row, result.penetration <= DEEPEST, "an overlap is deeper than 5 cm");
	check_end(row, &result);
	return true;
}

static bool time_once(SleepRow* row, const SleepSetting* setting, int repeat)
{
	uint64_t hash = row->last.hash;
	if (!sleep_trial_run(row->item, setting, row->compared, false, &row->last))
		return false;
	complain(row, row->last.hash == hash, "a timed run ended with another hash");
	check_end(row, &row->last);
	row->means[repeat] = row->last.mean;
	row->medians[repeat] = row->last.median;
	row->longest[repeat] = row->last.most;
	for (int k = 0; k < FIRST_STEPS; ++k)
		row->firsts[k][repeat] = row->last.first[k];
	return true;
}

// Computes medians over all timed runs. other: the row with which this one is compared, or null.
static void evaluate(SleepRow* row, const SleepRow* other, int repeats)
{
	double ratios[MAX_REPEATS];
	bool wakes = row->item->beside == BESIDE_LATER;
	for (int k = 0; k < repeats; ++k)
		ratios[k] = other ? row->means[k] / other->means[k] : row->longest[k] / row->medians[k];
	if (other || wakes)
		snprintf(row->ratio, sizeof row->ratio, "%.3f", median_of(ratios, repeats));
	for (int k = 0; k < FIRST_STEPS && wakes; ++k)
	{
		size_t length = strlen(row->first);
		snprintf(row->first + length, sizeof row->first - length, "%s%.3f", k > 0 ? " " : "",
		         median_of(row->firsts[k], repeats));
	}
}

// Computes the medians that sort the times, after all ratios.
static void evaluate_times(SleepRow* row, int repeats)
{
	row->mean = median_of(row->means, repeats);
	row->median = median_of(row->medians, repeats);
	row->most = median_of(row->longest, repeats);
}

void sleep_rows_heading(void)
{
	static const char* const names[] = {
#define X(name, format, value) #name,
#include "sleep_columns.def"
#undef X
	};
	for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k)
		printf("%s%s", k > 0 ? "," : "", names[k]);
	printf("\n");
}

static void print(const SleepRow* row, bool csv)
{
	const char* between = "";
#define X(name, format, value)                     \
	if (csv)                                       \
		printf("%s" format, between, value);       \
	else                                           \
		printf("%-14s" format "\n", #name, value); \
	between = ",";
#include "sleep_columns.def"
#undef X
	printf("\n");
	fflush(stdout);
}

bool sleep_rows_measure(const SleepCase* item, const SleepSetting* setting, bool csv, bool* valid)
{
	static SleepRow rows[2];
	int count = item->beside == BESIDE_AWAKE || item->beside == BESIDE_NO_SLEEP ? 2 : 1;
	for (int k = 0; k < count; ++k)
	{
		rows[k] = (SleepRow){.item = item, .compared = k > 0, .valid = true};
		if (!check(&rows[k], setting))
			return false;
	}
	for (int repeat = 0; repeat < setting->repeats; ++repeat)
	{
		for (int k = 0; k < count; ++k)
		{
			if (!time_once(&rows[k], setting, repeat))
				return false;
		}
	}
	for (int k = 0; k < count; ++k)
		evaluate(&rows[k], k + 1 < count ? &rows[k + 1] : NULL, setting->repeats);
	for (int k = 0; k < count; ++k)
	{
		evaluate_times(&rows[k], setting->repeats);
		print(&rows[k], csv);
		*valid = *valid && rows[k].valid;
	}
	return true;
}
