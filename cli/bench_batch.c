// SPDX-License-Identifier: MIT
// bench_batch.c -- scree bench --worlds: measures many copies of a scene in a batch, and compares them with one world alone.
//
// The first and the last world of a batch are never reset, so both must end with the hash of the same world alone, which is
// stepped on the CPU. The sum of all hashes must be the same in all runs.
#include "bench_batch.h"
#include "batch_scene.h"
#include "cli/common/csv.h"
#include "cli/common/known_hashes.h"
#include "cli/common/library_error.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include <inttypes.h>
#include <scree/scree_math.h>
#include <stdlib.h>
#include <string.h>

#define WARM_UP    2                 // steps of a run that are not measured, as in measurement.c
#define SEED       1                 // seed of the resets; another one gives other sums of hashes
#define MASK_BYTES ((size_t)1 << 26) // size of the masks that are made before their steps

typedef struct
{
	const Options* options;
	const Scene* scene;
	int worlds, steps;
	scree_world* alone; // template of the batch, then the world that is stepped alone
	scree_batch* batch;
	uint8_t*
	    masks; // masks of `ready` steps, which choose the worlds that are reset before the step; null without resets
	int ready;
	uint64_t* hashes;
	double* times; // s: measured steps of all runs
	int count;
	double least, most;           // s: median step of the fastest and of the slowest run
	uint64_t sum, other;          // sum of the hashes in the first run; last sum that differs from it, or the same sum
	uint64_t first, last, single; // hashes of the first world, of the last one, and of the world alone
	int threads, lanes;
} Run;

static bool allocate(Run* run)
{
	size_t most = MASK_BYTES / (size_t)run->worlds + 1;
	run->ready = most < (size_t)run->steps ? (int)most : run->steps;
	run->hashes = malloc((size_t)run->worlds * sizeof *run->hashes);
	run->times = malloc((size_t)run->steps * (size_t)run->options->repeats * sizeof *run->times);
	if (run->options->resets > 0.0f)
		run->masks = malloc((size_t)run->worlds * (size_t)run->ready);
	if (run->hashes && run->times && (run->masks || run->options->resets == 0.0f))
		return true;
	fprintf(stderr, "%s bench: out of memory for %d worlds and %d steps\n", program_name, run->worlds, run->steps);
	return false;
}

// Makes the masks of the steps from `step` on, then waits for the device, so that the next step is measured alone.
static scree_status make_masks(Run* run, int step)
{
	uint64_t limit = (uint64_t)((double)run->options->resets / 100.0 * 4294967296.0);
	for (int ahead = 0; ahead < run->ready; ++ahead)
		for (int k = 0; k < run->worlds; ++k)
			run->masks[(size_t)ahead * (size_t)run->worlds + (size_t)k] =
			    k > 0 && k < run->worlds - 1 &&
			    scree_random_make(SEED, (uint64_t)k, (uint32_t)(step + ahead), 0).words[0] < limit;
	return scree_batch_get_hashes(run->batch, run->hashes);
}

static scree_status take_steps(Run* run)
{
	const Scene* scene = run->scene;
	scree_status status = SCREE_OK;
	for (int step = 0; step < run->steps && status == SCREE_OK; ++step)
	{
		int ahead = step % run->ready;
		if (run->masks && ahead == 0)
			status = make_masks(run, step);
		double begin = seconds_now();
		if (run->masks && status == SCREE_OK)
			status = scree_batch_reset(run->batch, run->masks + (size_t)ahead * (size_t)run->worlds);
		if (status == SCREE_OK)
			status = scree_batch_step(run->batch, scene->dt, scene->substeps, 1);
		if (step >= WARM_UP || run->steps <= WARM_UP)
			run->times[run->count++] = seconds_now() - begin;
	}
	return status == SCREE_OK ? scree_batch_get_hashes(run->batch, run->hashes) : status;
}

// Steps the template alone, as long as the worlds of the batch, and compares.
static scree_status step_alone(Run* run)
{
	scree_status status = SCREE_OK;
	for (int step = 0; step < run->steps && status == SCREE_OK; ++step)
		status = scree_world_step(run->alone, run->scene->dt, run->scene->substeps);
	return status == SCREE_OK ? scree_world_get_hash(run->alone, &run->single) : status;
}

static void end_run(Run* run, int repeat, int begin)
{
	uint64_t sum = 0;
	for (int k = 0; k < run->worlds; ++k)
		sum += run->hashes[k];
	double middle = median_of(run->times + begin, run->count - begin);
	run->least = repeat == 0 || middle < run->least ? middle : run->least;
	run->most = middle > run->most ? middle : run->most;
	if (repeat == 0)
	{
		run->sum = run->other = sum;
		run->first = run->hashes[0];
		run->last = run->hashes[run->worlds - 1];
	}
	run->other = sum == run->sum ? run->other : sum;
}

static scree_status measure_once(Run* run, int repeat)
{
	scree_batch_def def = batch_definition(run->options, &run->alone);
	int begin = run->count;
	scree_status status = scree_batch_create(&def, &run->batch);
	if (status == SCREE_OK)
		status = take_steps(run);
	if (status == SCREE_OK)
		end_run(run, repeat, begin);
	scree_batch_destroy(run->batch);
	run->batch = NULL;
	return status;
}

static bool check(const Run* run, const Known* known, const char* settings)
{
	const char* name = run->scene->name;
	bool valid = true;
	if (run->first != run->single || run->last != run->single)
	{
		fprintf(stderr,
		        "%s bench: %s is invalid: the hash is %016" PRIx64 " alone, %016" PRIx64 " in world 0 and %016" PRIx64
		        " in world %d\n",
		        program_name, name, run->single, run->first, run->last, run->worlds - 1);
		valid = false;
	}
	if (run->other != run->sum)
	{
		fprintf(stderr,
		        "%s bench: %s is invalid: the sum of its hashes was %016" PRIx64 " in one run and %016" PRIx64
		        " in another\n",
		        program_name, name, run->sum, run->other);
		valid = false;
	}
	return known_agrees(known, run->options->known, name, settings, run->steps, run->single) && valid;
}

static void print_row(Run* run, const char* settings, bool valid)
{
	char device[160];
	bool cpu = strcmp(run->options->device, "cpu") == 0;
	double total = 0.0;
	for (int k = 0; k < run->count; ++k)
		total += run->times[k];
	snprintf(device, sizeof device, "%s", cpu ? "cpu" : run->options->device);
	csv_cell(device);
	printf("%s,%s,%s,%d,%d,%d,%g,%d,%d", run->scene->name, settings, device, cpu ? run->threads : 0,
	       cpu ? run->lanes : 0, run->worlds, (double)run->options->resets, run->scene->body_count, run->steps);
	printf(",%.4f,%.4f,%.4f,%.0f", 1e3 * median_of(run->times, run->count), 1e3 * run->least, 1e3 * run->most,
	       (double)run->worlds * run->count / total);
	printf(",%016" PRIx64 ",%016" PRIx64 ",%016" PRIx64 ",%016" PRIx64 ",%d\n", run->sum, run->first, run->last,
	       run->single, valid);
	fflush(stdout);
}

// Opens the world that is copied, on the CPU, and takes its steps before the copy.
static int open_template(const Options* options, const Scene* scene, ScenePlayer* player)
{
	Options of_template = *options;
	of_template.device = "cpu";
	int code = open_player(&of_template, scene, false, player);
	for (int step = 0; step < options->template_steps && code == EXIT_GOOD; ++step)
		code = report(player_step(player));
	return code;
}

static int measure(const Options* given, const Scene* scene, const Known* known, bool* invalid)
{
	Options changed = batch_options(given), *options = &changed;
	Run run = {.options = options, .scene = scene, .worlds = options->worlds, .steps = options_steps(options, scene)};
	ScenePlayer player = {0};
	char settings[256];
	settings_text(options, settings, sizeof settings);
	size_t length = strlen(settings);
	if (options->template_steps > 0)
		snprintf(settings + length, sizeof settings - length, "%s--template-steps=%d", length > 0 ? " " : "",
		         options->template_steps);
	int code = allocate(&run) ? EXIT_GOOD : EXIT_FAILED;
	if (code == EXIT_GOOD)
		code = open_template(options, scene, &player);
	run.alone = player.world;
	for (int repeat = 0; repeat < options->repeats && code == EXIT_GOOD; ++repeat)
		code = report(measure_once(&run, repeat));
	if (code == EXIT_GOOD)
		code = report(step_alone(&run));
	if (code == EXIT_GOOD)
	{
		run.threads = scree_world_get_threads(run.alone);
		run.lanes = scree_world_get_lanes(run.alone);
		bool valid = check(&run, known, settings);
		print_row(&run, settings, valid);
		*invalid = *invalid || !valid;
	}
	player_close(&player);
	free(run.masks);
	free(run.hashes);
	free(run.times);
	return code;
}

int measure_batches(const Options* options, const SceneList* list)
{
	Known known;
	bool invalid = false;
	if (options->argument_count == 0)
		fprintf(stderr, "%s bench: a scene is missing; --worlds measures no scenes but those of the arguments\n",
		        program_name);
	int code = known_open(options->known, &known);
	if (options->argument_count == 0)
		code = EXIT_BAD;
	for (int k = 0; k < list->count && code == EXIT_GOOD; ++k)
		code = batch_takes(options, list->scenes[k]) ? EXIT_GOOD : EXIT_BAD;
	if (code == EXIT_GOOD)
		printf("scene,settings,device,threads,lanes,worlds,resets,bodies,steps,ms_step,ms_least,ms_most,world_steps_s,"
		       "hash_sum,"
		       "hash_first,hash_last,hash,valid\n");
	for (int k = 0; k < list->count && code == EXIT_GOOD; ++k)
		code = measure(options, list->scenes[k], &known, &invalid);
	known_close(&known);
	return code == EXIT_GOOD && invalid ? EXIT_FAILED : code;
}
