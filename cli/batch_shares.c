// SPDX-License-Identifier: MIT
// batch_shares.c -- runs many copies of a scene in one batch, or in several that threads step at the same time, and measures the steps.
//
// While the host reads the outputs of one batch and writes its inputs, a device computes another one. The steps of several batches are
// measured together: each gets the same share of the time of all.
#include "batch_shares.h"
#include "batch_scene.h"
#include "cli/common/library_error.h"
#include "tools/common/clock.h"
#include <stdlib.h>

#define WARM_UP 2 // steps of a run that are not measured, as in measurement.c

int batch_shares_open(BatchShares* run)
{
	const Options* options = run->options;
	int shares = options->batches;
	run->worlds = batch_drive_make(options, 0, 1).worlds;
	run->share_count = shares;
	run->shares = calloc((size_t)shares, sizeof *run->shares);
	run->hashes = malloc((size_t)run->worlds * sizeof *run->hashes);
	run->counters = malloc((size_t)run->worlds * sizeof *run->counters);
	run->times = malloc((size_t)run->steps * sizeof *run->times);
	if (!run->shares || !run->hashes || !run->counters || !run->times)
	{
		fprintf(stderr, "%s bench: out of memory for %d worlds and %d steps\n", program_name, run->worlds, run->steps);
		return EXIT_FAILED;
	}
	for (int k = 0; k < shares; ++k)
		run->shares[k].drive = batch_drive_make(options, k, shares);
	run->threads = shares > 1 ? threads_open(shares, NULL) : NULL;
	return shares > 1 && !run->threads ? report(SCREE_ERROR_OUT_OF_MEMORY) : EXIT_GOOD;
}

void batch_shares_close(BatchShares* run)
{
	threads_close(run->threads);
	free(run->shares);
	free(run->hashes);
	free(run->counters);
	free(run->times);
}

// Executes a function for all shares, and returns an exit code.
static int each(BatchShares* run, BlockFunction* function)
{
	if (run->threads)
		threads_run_once(run->threads, function, run);
	else
		function(run, 0, 1);
	for (int k = 0; k < run->share_count; ++k)
		if (run->shares[k].status != SCREE_OK)
		{
			fprintf(stderr, "%s bench: %s\n", program_name, run->shares[k].sentence);
			return EXIT_FAILED;
		}
	return EXIT_GOOD;
}

static void note(BatchShare* share, scree_status status)
{
	share->status = status;
	if (status != SCREE_OK)
		snprintf(share->sentence, sizeof share->sentence, "%s", scree_error());
}

static void create(void* context, int k, int count)
{
	(void)count;
	BatchShares* run = context;
	BatchShare* share = run->shares + k;
	scree_world* template = run->alone;
	scree_batch_def def = batch_definition(run->options, &template);
	def.worlds = share->drive.worlds;
	note(share, scree_batch_create(&def, &share->batch));
}

// Binds inputs and outputs of all batches, one after another, because this reads the template.
static int bind(BatchShares* run)
{
	for (int k = 0; k < run->share_count; ++k)
	{
		BatchShare* share = run->shares + k;
		if (batch_drive_bind(&share->drive, share->batch, run->alone, run->steps, share->sentence))
			continue;
		fprintf(stderr, "%s bench: %s\n", program_name, share->sentence);
		return EXIT_FAILED;
	}
	return EXIT_GOOD;
}

// Returns the number of the first world of a batch among those of all batches.
static int first_of(const BatchShares* run, const BatchShare* share)
{
	return share->drive.first - run->shares[0].drive.first;
}

// Reads the hashes of a batch, for which the device finishes its steps.
static void read_hashes(BatchShares* run, BatchShare* share)
{
	note(share, scree_batch_get_hashes(share->batch, run->hashes + first_of(run, share)));
}

static void prepare(void* context, int k, int count)
{
	(void)count;
	BatchShares* run = context;
	read_hashes(run, run->shares + k);
	batch_drive_prepare(&run->shares[k].drive, run->begin);
}

static void take_steps(void* context, int k, int count)
{
	(void)count;
	BatchShares* run = context;
	BatchShare* share = run->shares + k;
	for (int step = run->begin; step < run->end && share->status == SCREE_OK; ++step)
	{
		double begin = seconds_now();
		note(share, batch_drive_step(&share->drive, step, run->scene->dt, run->scene->substeps));
		if (!run->threads)
			run->times[run->count++] = seconds_now() - begin;
	}
	if (run->threads && share->status == SCREE_OK)
		read_hashes(run, share);
}

static void read_results(void* context, int k, int count)
{
	(void)count;
	BatchShares* run = context;
	BatchShare* share = run->shares + k;
	read_hashes(run, share);
	if (share->status == SCREE_OK)
		note(share, scree_batch_get_counters(share->batch, run->counters + first_of(run, share)));
}

static int smaller(int a, int b) { return a < b ? a : b; }

// Takes the steps from `begin` to `end`, and measures them.
static int take(BatchShares* run, int begin, int end)
{
	run->begin = begin;
	run->end = end;
	double from = seconds_now();
	int code = each(run, take_steps);
	double time = (seconds_now() - from) / (end - begin);
	for (int step = begin; step < end && run->threads; ++step)
		run->times[run->count++] = time;
	return code;
}

static int take_all_steps(BatchShares* run)
{
	int steps = run->steps, ready = run->shares[0].drive.ready, warm_up = steps > WARM_UP ? WARM_UP : 0;
	int code = EXIT_GOOD;
	run->count = 0;
	for (int step = 0; step < steps && code == EXIT_GOOD; step += ready)
	{
		int end = steps - step < ready ? steps : step + ready, begin = step < warm_up ? smaller(warm_up, end) : step;
		run->begin = step;
		code = each(run, prepare);
		if (code == EXIT_GOOD && begin > step)
		{
			code = take(run, step, begin);
			run->count = 0;
		}
		if (code == EXIT_GOOD && end > begin)
			code = take(run, begin, end);
	}
	return code == EXIT_GOOD ? each(run, read_results) : code;
}

int batch_shares_measure(BatchShares* run)
{
	double begin = seconds_now();
	int code = each(run, create);
	run->create = seconds_now() - begin;
	if (code == EXIT_GOOD)
		code = bind(run);
	if (code == EXIT_GOOD)
		code = take_all_steps(run);
	run->columns = run->shares[0].drive.columns;
	for (int k = 0; k < run->share_count; ++k)
	{
		BatchShare* share = run->shares + k;
		batch_drive_close(&share->drive);
		scree_batch_destroy(share->batch);
		share->batch = NULL;
	}
	return code;
}
