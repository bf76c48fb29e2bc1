// SPDX-License-Identifier: MIT
// bench_batch.c -- scree bench --worlds: measures many copies of a scene in a batch, and compares them with one world alone.
//
// The first and the last world are never reset and have no random inputs, so both must end with the hash of the same world alone,
// which is stepped on the CPU. The sum of all hashes must be the same in all runs.
#include "bench_batch.h"
#include "batch_drive.h"
#include "batch_scene.h"
#include "cli/common/csv.h"
#include "cli/common/known_hashes.h"
#include "cli/common/library_error.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WARM_UP 2 // steps of a run that are not measured, as in measurement.c

typedef struct
{
	const Options* options;
	const Scene* scene;
	BatchDrive drive;
	int steps;
	scree_world* alone; // template of the batch, then the world that is stepped alone
	scree_batch* batch;
	uint64_t* hashes;
	scree_batch_counters* counters;
	double* times; // s: measured steps of all runs
	int count;
	double create;                // s: least time of the creation
	double least, most;           // s: median step of the fastest and of the slowest run
	uint64_t sum, other;          // sum of the hashes in the first run; last sum that differs from it, or the same sum
	uint64_t first, last, single; // hashes of the first world, of the last one, and of the world alone
	int threads, lanes;
} Run;

static bool allocate(Run* run)
{
	size_t worlds = (size_t)run->drive.worlds;
	run->hashes = malloc(worlds * sizeof *run->hashes);
	run->counters = malloc(worlds * sizeof *run->counters);
	run->times = malloc((size_t)run->steps * (size_t)run->options->repeats * sizeof *run->times);
	if (run->hashes && run->counters && run->times)
		return true;
	fprintf(stderr, "%s bench: out of memory for %d worlds and %d steps\n", program_name, run->drive.worlds,
	        run->steps);
	return false;
}

static scree_status take_steps(Run* run)
{
	const Scene* scene = run->scene;
	scree_status status = SCREE_OK;
	for (int step = 0; step < run->steps && status == SCREE_OK; ++step)
	{
		if (step % run->drive.ready == 0) // the device finishes, so that the next step is measured alone
			status = scree_batch_get_hashes(run->batch, run->hashes);
		batch_drive_prepare(&run->drive, step);
		double begin = seconds_now();
		if (status == SCREE_OK)
			status = batch_drive_step(&run->drive, step, scene->dt, scene->substeps);
		if (step >= WARM_UP || run->steps <= WARM_UP)
			run->times[run->count++] = seconds_now() - begin;
	}
	if (status == SCREE_OK)
		status = scree_batch_get_counters(run->batch, run->counters);
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
	for (int k = 0; k < run->drive.worlds; ++k)
		sum += run->hashes[k];
	double middle = median_of(run->times + begin, run->count - begin);
	run->least = repeat == 0 || middle < run->least ? middle : run->least;
	run->most = middle > run->most ? middle : run->most;
	if (repeat == 0)
	{
		run->sum = run->other = sum;
		run->first = run->hashes[0];
		run->last = run->hashes[run->drive.worlds - 1];
	}
	run->other = sum == run->sum ? run->other : sum;
}

static int measure_once(Run* run, int repeat)
{
	scree_batch_def def = batch_definition(run->options, &run->alone);
	char sentence[SCENE_SENTENCE];
	def.worlds = run->drive.worlds;
	double begin = seconds_now();
	int measured = run->count, code = report(scree_batch_create(&def, &run->batch));
	double create = seconds_now() - begin;
	run->create = repeat == 0 || create < run->create ? create : run->create;
	if (code == EXIT_GOOD && !batch_drive_bind(&run->drive, run->batch, run->alone, run->steps, sentence))
	{
		fprintf(stderr, "%s bench: %s\n", program_name, sentence);
		code = EXIT_FAILED;
	}
	if (code == EXIT_GOOD)
		code = report(take_steps(run));
	if (code == EXIT_GOOD)
		end_run(run, repeat, measured);
	return code;
}

// Ends a run; the columns and the number of its worlds stay.
static void close_run(Run* run)
{
	int columns = run->drive.columns;
	batch_drive_close(&run->drive);
	run->drive.columns = columns;
	scree_batch_destroy(run->batch);
	run->batch = NULL;
}

static bool check(const Run* run, const Known* known, const char* settings)
{
	const char* name = run->scene->name;
	const BatchDrive* drive = &run->drive;
	int last = drive->first + drive->worlds - 1;
	bool valid = true;
	if ((batch_drive_keeps(drive, drive->first) && run->first != run->single) ||
	    (batch_drive_keeps(drive, last) && run->last != run->single))
	{
		fprintf(stderr,
		        "%s bench: %s is invalid: the hash is %016" PRIx64 " alone, %016" PRIx64 " in world %d and %016" PRIx64
		        " in world %d\n",
		        program_name, name, run->single, run->first, drive->first, run->last, last);
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

// Prints the sums of the contacts and of the sleeping bodies of all worlds, and the largest of their overlaps and gaps of joints, m.
static void print_counters(const Run* run)
{
	int64_t contacts = 0, touching = 0, asleep = 0;
	double penetration = 0.0, joint_gap = 0.0;
	for (int k = 0; k < run->drive.worlds; ++k)
	{
		const scree_batch_counters* of = run->counters + k;
		contacts += of->contacts;
		touching += of->touching;
		asleep += of->asleep_bodies;
		penetration = fmax(penetration, of->penetration);
		joint_gap = fmax(joint_gap, of->joint_gap);
	}
	printf(",%" PRId64 ",%" PRId64 ",%" PRId64 ",%.4f,%.4f", contacts, touching, asleep, penetration, joint_gap);
}

static void print_row(Run* run, const char* settings, bool valid)
{
	const Options* options = run->options;
	bool cpu = strcmp(options->device, "cpu") == 0;
	char device[160];
	double total = 0.0;
	for (int k = 0; k < run->count; ++k)
		total += run->times[k];
	snprintf(device, sizeof device, "%s", options->device);
	csv_cell(device);
	printf("%s,%s,%s", run->scene->name, settings, device);
	printf(",%d,%d,%d,%d/%d,%g,%d,%d", cpu ? run->threads : 0, cpu ? run->lanes : 0, options->worlds, options->part,
	       options->parts, (double)options->resets, options->inputs, run->drive.columns);
	printf(",%d,%d,%.2f,%.4f,%.4f,%.4f,%.0f", run->scene->body_count, run->steps, 1e3 * run->create,
	       1e3 * median_of(run->times, run->count), 1e3 * run->least, 1e3 * run->most,
	       (double)run->drive.worlds * run->count / total);
	print_counters(run);
	printf(",%016" PRIx64 ",%016" PRIx64 ",%016" PRIx64 ",%016" PRIx64 ",%d\n", run->sum, run->first, run->last,
	       run->single, valid);
	fflush(stdout);
}

// Creates a batch of one world, which keeps the device open, so that the creation of a batch is measured without it.
static int open_device(const Run* run, scree_batch** batch)
{
	scree_world* world = run->alone;
	scree_batch_def def = batch_definition(run->options, &world);
	def.worlds = 1;
	return report(scree_batch_create(&def, batch));
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
	if (options->parts == 0)
		options->part = options->parts = 1;
	Run run = {
	    .options = options, .scene = scene, .drive = batch_drive_make(options), .steps = options_steps(options, scene)};
	ScenePlayer player = {0};
	scree_batch* open = NULL;
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
	if (code == EXIT_GOOD)
		code = open_device(&run, &open);
	for (int repeat = 0; repeat < options->repeats && code == EXIT_GOOD; ++repeat)
	{
		code = measure_once(&run, repeat);
		close_run(&run);
	}
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
	scree_batch_destroy(open);
	player_close(&player);
	free(run.hashes);
	free(run.counters);
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
		printf("scene,settings,device,threads,lanes,worlds,part,resets,inputs,columns,bodies,steps,ms_create,ms_step,"
		       "ms_least,ms_most,world_steps_s,contacts,touching,asleep,penetration,joint_gap,hash_sum,hash_first,hash_"
		       "last,hash,"
		       "valid\n");
	for (int k = 0; k < list->count && code == EXIT_GOOD; ++k)
		code = measure(options, list->scenes[k], &known, &invalid);
	known_close(&known);
	return code == EXIT_GOOD && invalid ? EXIT_FAILED : code;
}
