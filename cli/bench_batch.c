// SPDX-License-Identifier: MIT
// bench_batch.c -- scree bench --worlds: measures many copies of a scene in a batch, and compares them with one world alone.
//
// The first and the last world are never reset and have no random inputs, so both must end with the hash of the same world alone,
// which is stepped on the CPU. The sum of all hashes must be the same in all runs.
#include "bench_batch.h"
#include "batch_scene.h"
#include "batch_shares.h"
#include "cli/common/csv.h"
#include "cli/common/known_hashes.h"
#include "cli/common/library_error.h"
#include "tools/common/median.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct
{
	BatchShares run;
	double* times; // s: measured steps of all runs
	int count;
	double create;                // s: least time of the creation
	double least, most;           // s: median step of the fastest and of the slowest run
	uint64_t sum, other;          // sum of the hashes in the first run; last sum that differs from it, or the same sum
	uint64_t first, last, single; // hashes of the first world, of the last one, and of the world alone
} Bench;

// Steps the template alone, as long as the worlds of the batch, and compares.
static scree_status step_alone(Bench* bench)
{
	const BatchShares* run = &bench->run;
	scree_status status = SCREE_OK;
	for (int step = 0; step < run->steps && status == SCREE_OK; ++step)
		status = scree_world_step(run->alone, run->scene->dt, run->scene->substeps);
	return status == SCREE_OK ? scree_world_get_hash(run->alone, &bench->single) : status;
}

static void end_run(Bench* bench, int repeat)
{
	const BatchShares* run = &bench->run;
	uint64_t sum = 0;
	for (int k = 0; k < run->worlds; ++k)
		sum += run->hashes[k];
	memcpy(bench->times + bench->count, run->times, (size_t)run->count * sizeof *run->times);
	bench->count += run->count;
	double middle = median_of(run->times, run->count);
	bench->create = repeat == 0 || run->create < bench->create ? run->create : bench->create;
	bench->least = repeat == 0 || middle < bench->least ? middle : bench->least;
	bench->most = middle > bench->most ? middle : bench->most;
	if (repeat == 0)
	{
		bench->sum = bench->other = sum;
		bench->first = run->hashes[0];
		bench->last = run->hashes[run->worlds - 1];
	}
	bench->other = sum == bench->sum ? bench->other : sum;
}

static bool check(const Bench* bench, const Known* known, const char* settings)
{
	const BatchShares* run = &bench->run;
	const char* name = run->scene->name;
	const BatchDrive* drive = &run->shares[0].drive;
	int last = drive->first + run->worlds - 1;
	bool valid = true;
	if ((batch_drive_keeps(drive, drive->first) && bench->first != bench->single) ||
	    (batch_drive_keeps(drive, last) && bench->last != bench->single))
	{
		fprintf(stderr,
		        "%s bench: %s is invalid: the hash is %016" PRIx64 " alone, %016" PRIx64 " in world %d and %016" PRIx64
		        " in world %d\n",
		        program_name, name, bench->single, bench->first, drive->first, bench->last, last);
		valid = false;
	}
	if (bench->other != bench->sum)
	{
		fprintf(stderr,
		        "%s bench: %s is invalid: the sum of its hashes was %016" PRIx64 " in one run and %016" PRIx64
		        " in another\n",
		        program_name, name, bench->sum, bench->other);
		valid = false;
	}
	return known_agrees(known, run->options->known, name, settings, run->steps, bench->single) && valid;
}

// Prints the sums of the contacts and of the sleeping bodies of all worlds, and the largest of their overlaps and gaps of joints, m.
static void print_counters(const BatchShares* run)
{
	int64_t contacts = 0, touching = 0, asleep = 0;
	double penetration = 0.0, joint_gap = 0.0;
	for (int k = 0; k < run->worlds; ++k)
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

static void print_row(const Bench* bench, const char* settings, bool valid)
{
	const BatchShares* run = &bench->run;
	const Options* options = run->options;
	bool cpu = strcmp(options->device, "cpu") == 0;
	char device[160];
	double total = 0.0;
	for (int k = 0; k < bench->count; ++k)
		total += bench->times[k];
	snprintf(device, sizeof device, "%s", options->device);
	csv_cell(device);
	printf("%s,%s,%s", run->scene->name, settings, device);
	printf(",%d,%d", cpu ? scree_world_get_threads(run->alone) : 0, cpu ? scree_world_get_lanes(run->alone) : 0);
	printf(",%d,%d/%d,%d,%g,%d,%d", options->worlds, options->part, options->parts, options->batches,
	       (double)options->resets, options->inputs, run->columns);
	printf(",%d,%d,%.2f,%.4f,%.4f,%.4f,%.0f", run->scene->body_count, run->steps, 1e3 * bench->create,
	       1e3 * median_of(bench->times, bench->count), 1e3 * bench->least, 1e3 * bench->most,
	       (double)run->worlds * bench->count / total);
	print_counters(run);
	printf(",%016" PRIx64 ",%016" PRIx64 ",%016" PRIx64 ",%016" PRIx64 ",%d\n", bench->sum, bench->first, bench->last,
	       bench->single, valid);
	fflush(stdout);
}

// Creates a batch of one world, which keeps the device open, so that the creation of a batch is measured without it.
static int open_device(const BatchShares* run, scree_batch** batch)
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

static int measure_runs(Bench* bench)
{
	BatchShares* run = &bench->run;
	int repeats = run->options->repeats, code = batch_shares_open(run);
	bench->times = malloc((size_t)run->steps * (size_t)repeats * sizeof *bench->times);
	if (code == EXIT_GOOD && !bench->times)
	{
		fprintf(stderr, "%s bench: out of memory for %d runs\n", program_name, repeats);
		code = EXIT_FAILED;
	}
	for (int repeat = 0; repeat < repeats && code == EXIT_GOOD; ++repeat)
	{
		code = batch_shares_measure(run);
		if (code == EXIT_GOOD)
			end_run(bench, repeat);
	}
	return code;
}

static int measure(const Options* given, const Scene* scene, const Known* known, bool* invalid)
{
	Options changed = batch_options(given), *options = &changed;
	Bench bench = {.run = {.options = options, .scene = scene, .steps = options_steps(options, scene)}};
	ScenePlayer player = {0};
	scree_batch* open = NULL;
	char settings[256];
	settings_text(options, settings, sizeof settings);
	size_t length = strlen(settings);
	if (options->template_steps > 0)
		snprintf(settings + length, sizeof settings - length, "%s--template-steps=%d", length > 0 ? " " : "",
		         options->template_steps);
	int code = open_template(options, scene, &player);
	bench.run.alone = player.world;
	if (code == EXIT_GOOD)
		code = open_device(&bench.run, &open);
	if (code == EXIT_GOOD)
		code = measure_runs(&bench);
	if (code == EXIT_GOOD)
		code = report(step_alone(&bench));
	if (code == EXIT_GOOD)
	{
		bool valid = check(&bench, known, settings);
		print_row(&bench, settings, valid);
		*invalid = *invalid || !valid;
	}
	scree_batch_destroy(open);
	player_close(&player);
	batch_shares_close(&bench.run);
	free(bench.times);
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
		printf("scene,settings,device,threads,lanes,worlds,part,batches,resets,inputs,columns,bodies,steps,ms_create,"
		       "ms_step,"
		       "ms_least,ms_most,world_steps_s,contacts,touching,asleep,penetration,joint_gap,hash_sum,hash_first,hash_"
		       "last,hash,"
		       "valid\n");
	for (int k = 0; k < list->count && code == EXIT_GOOD; ++k)
		code = measure(options, list->scenes[k], &known, &invalid);
	known_close(&known);
	return code == EXIT_GOOD && invalid ? EXIT_FAILED : code;
}
