// SPDX-License-Identifier: MIT
// trial.c -- runs a scene in an engine, and either measures the time of the steps or measures the poses after them.
#include "trial.h"
#include "measure.h"
#include "mirror.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include <inttypes.h>
#include <stdlib.h>

// Number of steps at the start that are not timed: buffers grow, the first contacts are found and threads start.
#define WARM_UP 2

static bool run_timed(Mirror* mirror, const Trial* trial, Result* result)
{
	double* times = malloc((size_t)trial->steps * sizeof(double));
	if (!times)
	{
		fprintf(stderr, "scree_peers: no memory for %d steps\n", trial->steps);
		return false;
	}
	int warm = trial->steps > WARM_UP ? WARM_UP : 0, counted = trial->steps - warm;
	int first = trial->steps > FIRST_STEPS ? FIRST_STEPS : trial->steps;
	double begin = 1e3 * seconds_now(), mark = begin;
	bool good = true;
	for (int k = 0; k < trial->steps && good; ++k)
	{
		good = mirror_change(mirror, k) && mirror_step(mirror);
		if (k == warm - 1 || k == first - 1)
			good = good && mirror->engine->wait(mirror->state);
		double now = 1e3 * seconds_now();
		times[k] = now - mark;
		mark = now;
		if (k == warm - 1)
			begin = now;
		if (k == first - 1)
			result->first = (now - begin) / (first - warm);
	}
	good = good && mirror->engine->wait(mirror->state);
	result->mean = (1e3 * seconds_now() - begin) / counted;
	result->median = upper_median_of(times + warm, counted);
	free(times);
	return good;
}

// Counts the awake bodies after step k.
static bool count_awake(const Mirror* mirror, int k, Result* result)
{
	bool slept = k > 0 && result->awake == 0;
	if (!mirror->engine->awake(mirror->state, &result->awake))
		return false;
	if (result->awake > 0)
		result->rested = 0;
	else if (!slept)
		result->rested = k + 1;
	return true;
}

static bool run_measured(Mirror* mirror, const Trial* trial, Result* result)
{
	Measure measure;
	bool good = measure_open(&measure, trial->setup) && mirror_poses(mirror, measure.poses) && measure_take(&measure);
	for (int k = 0; k < trial->steps && good; ++k)
		good = mirror_change(mirror, k) && mirror_step(mirror) && measure_change(&measure, trial->setup, k) &&
		       mirror_poses(mirror, measure.poses) && measure_take(&measure) && count_awake(mirror, k, result);
	result->penetration = measure.penetration;
	result->sunk = measure.sunk;
	result->separation = measure.separation;
	result->gap = (float)measure_gap(&measure);
	if (measure.measured > 0)
	{
		result->depth = (float)(measure.depths / measure.measured);
		result->contacts = (float)(measure.contacts / measure.measured);
	}
	measure_close(&measure);
	return good;
}

bool trial_run(const Engine* engine, const Trial* trial, Result* result)
{
	*result = (Result){0};
	Mirror mirror;
	bool good = mirror_open(&mirror, trial->setup, engine, &trial->options) &&
	            (trial->measured ? run_measured : run_timed)(&mirror, trial, result) &&
	            engine->hash(mirror.state, &result->hash);
	mirror_close(&mirror);
	return good;
}

void result_print(const Result* r)
{
	printf("%.6f %.6f %.6f %.6f %.6f %.1f %.6f %.6f %.9f %d %d %016" PRIx64 "\n", r->mean, r->median, r->first,
	       (double)r->penetration, (double)r->depth, (double)r->contacts, (double)r->sunk, (double)r->separation,
	       (double)r->gap, r->awake, r->rested, r->hash);
}

bool result_scan(const char* line, Result* r)
{
	return sscanf(line, "%lf %lf %lf %f %f %f %f %f %f %d %d %" SCNx64, &r->mean, &r->median, &r->first,
	              &r->penetration, &r->depth, &r->contacts, &r->sunk, &r->separation, &r->gap, &r->awake, &r->rested,
	              &r->hash) == 12;
}
