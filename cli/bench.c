// SPDX-License-Identifier: MIT
// bench.c -- the command that measures scenes and proves that the work was done.
//
// A GPU's clocks between kernels cost time themselves. So the repeats run without them and give ms_step; one more run,
// with them, gives the stages. Its hash must be the same.
#include "commands.h"
#include "record.h"
#include <inttypes.h>
#include <stdlib.h>

// Steps at the start of each run whose time does not count: kernels are built, buffers grow, threads wake up.
#define WARM_UP 2

typedef struct
{
	Record* records; // of the steps whose time counts, of all repeats
	int count;
	int staged;        // of these, the ones of the last run, with milliseconds by stage
	float penetration; // deepest of all steps, m
	uint64_t hash;
	bool equal, finite;
	char device[160];
	int threads, lanes;
} Measurement;

static int measure_once(const Options* options, const Scene* scene, int steps, bool first, bool timings, Measurement* m)
{
	Simulation simulation;
	int code = simulation_open(options, scene, timings, &simulation);
	if (code != EXIT_GOOD)
		return code;
	scree_status status = SCREE_OK;
	for (int step = 0; step < steps && status == SCREE_OK; ++step)
	{
		Record record;
		status = record_step(&simulation, &record);
		if (status != SCREE_OK)
			break;
		if (deepest(&record, 1) > m->penetration)
			m->penetration = deepest(&record, 1);
		m->finite = m->finite && record.counters.nonfinite == 0;
		if (step >= WARM_UP || steps <= WARM_UP)
		{
			m->records[m->count++] = record;
			m->staged += timings;
		}
	}
	uint64_t hash = 0;
	if (status == SCREE_OK)
		status = simulation.f->hash(&simulation, &hash);
	m->equal = m->equal && (first || hash == m->hash);
	m->hash = hash;
	snprintf(m->device, sizeof m->device, "%s", scree_world_device(simulation.world));
	m->threads = scree_world_threads(simulation.world);
	m->lanes = scree_world_lanes(simulation.world);
	simulation_close(&simulation);
	return report(status);
}

static void print_row(const Scene* scene, Measurement* m, int steps)
{
	// a comma in a driver's name must not make a column
	for (char* c = m->device; *c; ++c)
		*c = *c == ',' ? ' ' : *c;
	bool valid = m->equal && m->finite && m->penetration <= scene->penetration_limit;
	int count = m->count - m->staged;
	const Record* staged = m->records + count;
	printf("%s,%s,%d,%d,%d,%.0f,%.0f,%d,%.4f", scene->name, m->device, m->threads, m->lanes,
	       m->records[count - 1].counters.bodies, median(m->records, count, contacts_of, 0),
	       median(m->records, count, colors_of, 0), steps, median(m->records, count, step_of, 0));
	for (int k = 0; k < STAGE_COLUMNS; ++k)
		printf(",%.4f", median(staged, m->staged, stage_of, k));
	printf(",%.5f,%016" PRIx64 ",%d\n", (double)m->penetration, m->hash, valid);
	fflush(stdout);
}

static int measure(const Options* options, const Scene* scene)
{
	int steps = options->steps > 0 ? options->steps : scene->steps;
	Measurement m = {.equal = true, .finite = true};
	m.records = malloc((size_t)steps * (size_t)(options->repeats + 1) * sizeof(Record));
	int code = m.records ? EXIT_GOOD : EXIT_FAILED;
	if (!m.records)
		fprintf(stderr, "scree bench: out of memory for %d steps\n", steps);
	for (int repeat = 0; repeat <= options->repeats && code == EXIT_GOOD; ++repeat)
		code = measure_once(options, scene, steps, repeat == 0, repeat == options->repeats, &m);
	if (code == EXIT_GOOD)
		print_row(scene, &m, steps);
	free(m.records);
	return code;
}

// Reads all scenes before the first is measured, so that a bad one costs nothing.
static int measure_all(const Options* options, char** names, int count)
{
	Scene** scenes = calloc((size_t)count + 1, sizeof(Scene*));
	int code = scenes ? EXIT_GOOD : EXIT_FAILED;
	for (int k = 0; k < count && code == EXIT_GOOD; ++k)
	{
		scenes[k] = open_scene(options, names[k]);
		code = scenes[k] ? EXIT_GOOD : EXIT_BAD;
	}
	if (code == EXIT_GOOD && options->whole)
		code = whole_command(options, scenes, count);
	else if (code == EXIT_GOOD)
	{
		printf("scene,device,threads,lanes,bodies,contacts,colors,steps,ms_step");
		for (int k = 0; k < STAGE_COLUMNS; ++k)
			printf(",ms_%s", pipeline_functions(options->pipeline)->stages[k]);
		printf(",penetration,hash,valid\n");
	}
	for (int k = 0; k < count && code == EXIT_GOOD && !options->whole; ++k)
		code = measure(options, scenes[k]);
	for (int k = 0; scenes && k < count; ++k)
		scene_free(scenes[k]);
	free(scenes);
	return code;
}

int bench_command(const Options* options)
{
	if (options->argument_count > 0)
		return measure_all(options, options->arguments, options->argument_count);
	char** names;
	int count = scene_list(options->executable, &names);
	int code = measure_all(options, names, count);
	for (int k = 0; k < count; ++k)
		free(names[k]);
	free(names);
	return code;
}
