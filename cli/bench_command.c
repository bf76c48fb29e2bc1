// SPDX-License-Identifier: MIT
// bench_command.c -- scree bench: measures scenes and checks that the work was done.
//
// Timing each kernel of a GPU costs time itself. So the repeats run without timings and give ms_step. One more run with
// timings gives the stages; its hash must be the same.
#include "bench_whole.h"
#include "commands.h"
#include "csv.h"
#include "known_hashes.h"
#include "library_error.h"
#include "scene/find.h"
#include "scene/load.h"
#include "step_record.h"
#include <inttypes.h>
#include <stdlib.h>

// Steps at the start of each run that are not timed: kernels are built, buffers grow, threads start.
#define WARM_UP 2

typedef struct
{
	const Options* options;
	Known known;
	char settings[256];
	double bandwidth; // of the device, bytes a second; 0 until it has been measured
	bool invalid;     // any row is
} Bench;

typedef struct
{
	Record* records; // of the timed steps of all runs
	int count;
	int staged;                      // records of the last run, which have milliseconds by stage
	double least, most;              // median step of the fastest and of the slowest repeat, ms
	float penetration;               // deepest of all steps, m
	uint64_t hash, other;            // of the first run, and of a later run if it differs
	uint64_t answers, other_answers; // the same of the rays of the scene
	int nonfinite;                   // steps that froze a body
	char device[160];
	int threads, lanes;
} Measurement;

static scree_status take_steps(Simulation* simulation, int steps, Measurement* m)
{
	for (int step = 0; step < steps; ++step)
	{
		Record record;
		scree_status status = record_step(simulation, &record);
		if (status != SCREE_OK)
			return status;
		if (deepest(&record, 1) > m->penetration)
			m->penetration = deepest(&record, 1);
		m->nonfinite += record.counters.frozen_bodies > 0;
		if (step >= WARM_UP || steps <= WARM_UP)
			m->records[m->count++] = record;
	}
	return SCREE_OK;
}

// Runs a scene once. The last run is timed by stage.
static int measure_once(Bench* bench, const Scene* scene, int steps, int repeat, Measurement* m)
{
	Simulation simulation;
	bool timings = repeat == bench->options->repeats;
	int code = simulation_open(bench->options, scene, timings, &simulation), before = m->count;
	if (code != EXIT_GOOD)
		return code;
	uint64_t hash = 0;
	scree_status status = take_steps(&simulation, steps, m);
	if (status == SCREE_OK)
		status = simulation.pipeline->hash(&simulation, &hash);
	if (status == SCREE_OK && bench->bandwidth == 0 && simulation.pipeline->solve >= 0)
		status = scree_world_measure_bandwidth(simulation.world, &bench->bandwidth);
	if (repeat == 0)
	{
		m->hash = m->other = hash;
		m->answers = m->other_answers = simulation.answered.hash;
	}
	m->other = hash == m->hash ? m->other : hash;
	if (simulation.answered.hash != m->answers)
		m->other_answers = simulation.answered.hash;
	if (timings)
		m->staged = m->count - before;
	else
	{
		double middle = median(m->records + before, m->count - before, step_of, 0);
		m->least = repeat == 0 || middle < m->least ? middle : m->least;
		m->most = middle > m->most ? middle : m->most;
	}
	snprintf(m->device, sizeof m->device, "%s", scree_world_get_device(simulation.world));
	m->threads = scree_world_get_threads(simulation.world);
	m->lanes = scree_world_get_lanes(simulation.world);
	simulation_close(&simulation);
	return report(status);
}

// Whether the work was done; if not, prints why.
static bool check_work(const Bench* bench, const Scene* scene, const Measurement* m, int steps)
{
	bool valid = true;
	uint64_t known;
	if (m->nonfinite > 0)
	{
		fprintf(stderr, "scree bench: %s is invalid: bodies whose state was not finite were frozen in %d steps\n",
		        scene->name, m->nonfinite);
		valid = false;
	}
	if (!(m->penetration <= scene->penetration_limit))
	{
		fprintf(stderr, "scree bench: %s is invalid: its deepest overlap is %g m, its penetration_limit %g\n",
		        scene->name, (double)m->penetration, (double)scene->penetration_limit);
		valid = false;
	}
	if (m->other != m->hash)
	{
		fprintf(stderr,
		        "scree bench: %s is invalid: its hash was %016" PRIx64 " in one run and %016" PRIx64 " in another\n",
		        scene->name, m->hash, m->other);
		valid = false;
	}
	if (m->other_answers != m->answers)
	{
		fprintf(stderr,
		        "scree bench: %s is invalid: the hash of its rays was %016" PRIx64 " in one run and %016" PRIx64
		        " in another\n",
		        scene->name, m->answers, m->other_answers);
		valid = false;
	}
	if (known_find(&bench->known, scene->name, bench->settings, steps, &known) && known != m->hash)
	{
		fprintf(stderr, "scree bench: %s is invalid: its hash is %016" PRIx64 ", but %s has %016" PRIx64 "\n",
		        scene->name, m->hash, bench->options->known, known);
		valid = false;
	}
	return valid;
}

static void print_heading(const Pipeline* f)
{
	printf("scene,settings,device,threads,lanes,bodies,contacts,touching,colors,steps,ms_step,ms_least,ms_most");
	for (int k = 0; k < STAGE_COLUMNS; ++k)
		printf(",ms_%s", f->stages[k]);
	printf(",bytes_a_body,mb_constraints,mb_bodies,gbs_solve,gbs_copy,rays,ray_hits,ms_rays,hash_rays,penetration,hash,"
	       "valid\n");
}

static void print_row(const Bench* bench, const Scene* scene, Measurement* m, int steps, bool valid)
{
	csv_cell(m->device);
	int count = m->count - m->staged;
	const Record* staged = m->records + count;
	const scree_counters* last = &m->records[count - 1].counters;
	printf("%s,%s,%s,%d,%d,%d,%.0f,%.0f,%.0f,%d", scene->name, bench->settings, m->device, m->threads, m->lanes,
	       last->bodies, median(m->records, count, contacts_of, 0), median(m->records, count, touching_of, 0),
	       median(m->records, count, colors_of, 0), steps);
	printf(",%.4f,%.4f,%.4f", median(m->records, count, step_of, 0), m->least, m->most);
	for (int k = 0; k < STAGE_COLUMNS; ++k)
		printf(",%.4f", median(staged, m->staged, stage_of, k));
	printf(",%.0f,%.3f,%.3f,%.2f,%.2f", last->bodies > 0 ? (double)last->device_bytes / last->bodies : 0.0,
	       1e-6 * median(m->records, count, constraint_bytes_of, 0), 1e-6 * median(m->records, count, body_bytes_of, 0),
	       1e-9 * median(staged, m->staged, solve_rate_of, 0), 1e-9 * bench->bandwidth);
	printf(",%d,%.0f,%.4f,%016" PRIx64, m->records[count - 1].rays, median(m->records, count, hits_of, 0),
	       median(m->records, count, scan_of, 0), m->answers);
	printf(",%.5f,%016" PRIx64 ",%d\n", (double)m->penetration, m->hash, valid);
	fflush(stdout);
}

static int measure(Bench* bench, const Scene* scene)
{
	const Options* options = bench->options;
	int steps = options_steps(options, scene);
	Measurement m = {0};
	m.records = malloc((size_t)steps * (size_t)(options->repeats + 1) * sizeof(Record));
	int code = m.records ? EXIT_GOOD : EXIT_FAILED;
	if (!m.records)
		fprintf(stderr, "scree bench: out of memory for %d steps\n", steps);
	for (int repeat = 0; repeat <= options->repeats && code == EXIT_GOOD; ++repeat)
		code = measure_once(bench, scene, steps, repeat, &m);
	if (code == EXIT_GOOD)
	{
		bool valid = check_work(bench, scene, &m, steps);
		print_row(bench, scene, &m, steps, valid);
		bench->invalid = bench->invalid || !valid;
	}
	free(m.records);
	return code;
}

// Loads all scenes before it measures the first, so that an error is found early.
static int measure_all(Bench* bench, char** names, int count)
{
	const Options* options = bench->options;
	Scene** scenes = calloc((size_t)count + 1, sizeof(Scene*));
	int code = scenes ? known_open(options->known, &bench->known) : EXIT_FAILED;
	for (int k = 0; k < count && code == EXIT_GOOD; ++k)
	{
		scenes[k] = open_scene(options, names[k]);
		code = scenes[k] ? EXIT_GOOD : EXIT_BAD;
	}
	settings_text(options, bench->settings, sizeof bench->settings);
	if (code == EXIT_GOOD && options->whole)
		code = measure_whole_runs(options, scenes, count);
	else if (code == EXIT_GOOD)
		print_heading(choose_pipeline(options->pipeline));
	for (int k = 0; k < count && code == EXIT_GOOD && !options->whole; ++k)
		code = measure(bench, scenes[k]);
	for (int k = 0; scenes && k < count; ++k)
		scene_free(scenes[k]);
	free(scenes);
	known_close(&bench->known);
	return code == EXIT_GOOD && bench->invalid ? EXIT_FAILED : code;
}

int bench_command(const Options* options)
{
	Bench bench = {.options = options};
	if (options->argument_count > 0)
		return measure_all(&bench, options->arguments, options->argument_count);
	char **names, missing[SCENE_SENTENCE];
	int count = scene_list(options->executable, &names, missing);
	if (count == 0)
		fprintf(stderr, "scree bench: %s\n", missing);
	int code = count > 0 ? measure_all(&bench, names, count) : EXIT_FAILED;
	for (int k = 0; k < count; ++k)
		free(names[k]);
	free(names);
	return code;
}
