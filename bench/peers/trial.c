// SPDX-License-Identifier: MIT
// trial.c -- one engine, one scene, one process: timed, or measured with the ruler.
#include "trial.h"
#include "measure.h"
#include <inttypes.h>
#include <stdlib.h>
#include <time.h>

// Steps at the start that are not timed: buffers grow, contacts are found for the first time, threads start.
#define WARM_UP 2

static double milliseconds(void)
{
	struct timespec now;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static int rising(const void* a, const void* b)
{
	double x = *(const double*)a, y = *(const double*)b;
	return (x > y) - (x < y);
}

static bool run_timed(const Engine* engine, void* state, const Trial* trial, Result* result)
{
	double* times = malloc((size_t)trial->steps * sizeof(double));
	if (!times)
	{
		fprintf(stderr, "scree_peers: no memory for %d steps\n", trial->steps);
		return false;
	}
	int warm = trial->steps > WARM_UP ? WARM_UP : 0, counted = trial->steps - warm;
	int first = trial->steps > FIRST_STEPS ? FIRST_STEPS : trial->steps;
	double begin = milliseconds(), mark = begin;
	bool good = true;
	for (int k = 0; k < trial->steps && good; ++k)
	{
		good = engine->change(state, k) && engine->step(state, trial->setup->dt, trial->setup->substeps);
		if (k == warm - 1 || k == first - 1)
			good = good && engine->wait(state);
		double now = milliseconds();
		times[k] = now - mark;
		mark = now;
		if (k == warm - 1)
			begin = now;
		if (k == first - 1)
			result->first = (now - begin) / (first - warm);
	}
	good = good && engine->wait(state);
	result->mean = (milliseconds() - begin) / counted;
	qsort(times + warm, (size_t)counted, sizeof(double), rising);
	result->median = times[warm + counted / 2];
	free(times);
	return good;
}

static bool run_ruled(const Engine* engine, void* state, const Trial* trial, Result* result)
{
	Ruler ruler;
	bool good =
	    ruler_open(&ruler, trial->setup) && engine->poses(state, ruler.poses, ruler.count) && ruler_measure(&ruler);
	for (int k = 0; k < trial->steps && good; ++k)
		good = engine->change(state, k) && engine->step(state, trial->setup->dt, trial->setup->substeps) &&
		       ruler_change(&ruler, trial->setup, k) && engine->poses(state, ruler.poses, ruler.count) &&
		       ruler_measure(&ruler);
	result->penetration = ruler.penetration;
	result->sunk = ruler.sunk;
	result->separation = ruler.separation;
	result->gap = (float)ruler_gap(&ruler);
	if (ruler.measured > 0)
	{
		result->depth = (float)(ruler.depths / ruler.measured);
		result->contacts = (float)(ruler.contacts / ruler.measured);
	}
	ruler_close(&ruler);
	return good;
}

bool trial_run(const Engine* engine, const Trial* trial, Result* result)
{
	*result = (Result){0};
	void* state = engine->open(trial->setup, &trial->options);
	if (!state)
		return false;
	bool good = (trial->ruled ? run_ruled : run_timed)(engine, state, trial, result);
	good = good && engine->hash(state, &result->hash);
	engine->close(state);
	return good;
}

void result_print(const Result* r)
{
	printf("%.6f %.6f %.6f %.6f %.6f %.1f %.6f %.6f %.9f %016" PRIx64 "\n", r->mean, r->median, r->first,
	       (double)r->penetration, (double)r->depth, (double)r->contacts, (double)r->sunk, (double)r->separation,
	       (double)r->gap, r->hash);
}

bool result_scan(const char* line, Result* r)
{
	return sscanf(line, "%lf %lf %lf %f %f %f %f %f %f %" SCNx64, &r->mean, &r->median, &r->first, &r->penetration,
	              &r->depth, &r->contacts, &r->sunk, &r->separation, &r->gap, &r->hash) == 10;
}
