// SPDX-License-Identifier: MIT
// run_command.c -- scree run, which prints a table of results, and scree hash, which prints the hash.
#include "commands.h"
#include "library_error.h"
#include "outputs.h"
#include "scene/caption.h"
#include "scene/load.h"
#include <inttypes.h>
#include <unistd.h>

#define BAR       40   // characters
#define BAR_PAUSE 0.05 // s between two states of the bar

typedef struct // of all steps
{
	Record last;
	double seconds; // of the steps
	double stages[STAGE_COLUMNS];
	double scans; // s: of the rays of the scene
	float penetration, joint_gap;
	int nonfinite;
} Totals;

static void show_progress(int step, int steps, double* shown)
{
	double now = seconds_now();
	if (step < steps && now - *shown < BAR_PAUSE)
		return;
	*shown = now;
	int full = (int)((int64_t)BAR * step / steps);
	fprintf(stderr, "\r%d of %d steps [%.*s%*s]%s", step, steps, full, "########################################",
	        BAR - full, "", step < steps ? "" : "\r\033[K");
}

static void add_record(Totals* totals, const Record* record)
{
	totals->last = *record;
	totals->seconds += 1e-3 * (double)record->milliseconds;
	totals->scans += 1e-3 * (double)record->scan;
	for (int k = 0; k < STAGE_COLUMNS; ++k)
		totals->stages[k] += (double)record->stages[k];
	if (record->counters.penetration > totals->penetration)
		totals->penetration = record->counters.penetration;
	if (record->counters.joint_gap > totals->joint_gap)
		totals->joint_gap = record->counters.joint_gap;
	totals->nonfinite += record->counters.frozen_bodies;
}

static int take_steps(Simulation* simulation, Outputs* outputs, int steps, Totals* totals)
{
	bool bar = isatty(STDOUT_FILENO) && isatty(STDERR_FILENO);
	double shown = 0;
	for (int step = 1; step <= steps; ++step)
	{
		Record record;
		scree_status status = record_step(simulation, &record);
		if (status != SCREE_OK)
			return report(status);
		add_record(totals, &record);
		int code = outputs_step(outputs, simulation, &record);
		if (code != EXIT_GOOD)
			return code;
		if (bar)
			show_progress(step, steps, &shown);
	}
	return EXIT_GOOD;
}

static void print_table(const Simulation* simulation, const Totals* totals, int steps, uint64_t hash)
{
	char device[192];
	const scree_counters* c = &totals->last.counters;
	device_text(simulation->world, device, sizeof device);
	printf("%-14s %s: %s\n", "scene", simulation->scene->name, simulation->scene->title);
	printf("%-14s %s\n", "device", device);
	printf("%-14s %d\n", "bodies", c->bodies);
	printf("%-14s %d, %d touching\n", "contacts", c->contacts, c->touching);
	printf("%-14s %d, %d contacts of hubs\n", "colors", c->colors, c->spokes);
	printf("%-14s %d in %.3f s\n", "steps", steps, totals->seconds);
	printf("%-14s %.1f\n", "steps/s", steps / totals->seconds);
	printf("%-14s %.4f\n", "ms/step", 1000 * totals->seconds / steps);
	for (int k = 0; k < STAGE_COLUMNS; ++k)
		printf("  %-12s %.4f\n", simulation->pipeline->stages[k], totals->stages[k] / steps);
	printf("%-14s %.4f m now, %.4f m the deepest seen\n", "penetration", (double)c->penetration,
	       (double)totals->penetration);
	printf("%-14s %.4f m now, %.4f m the widest seen\n", "joint gap", (double)c->joint_gap, (double)totals->joint_gap);
	if (totals->nonfinite > 0)
		printf("%-14s %d bodies were frozen because their state was not finite\n", "warning", totals->nonfinite);
	printf("%-14s %016" PRIx64 "\n", "hash", hash);
	if (simulation->scene->character_count > 0)
		printf("%-14s %d bodies by characters\n", "taken", simulation->walkers.taken);
	if (simulation->scene->fan_count == 0)
		return;
	const ScanSum* sum = &simulation->answered;
	printf("%-14s %.0f a step, %.0f hit\n", "rays", (double)sum->rays / steps, (double)sum->hits / steps);
	printf("%-14s %.4f apart from the step\n", "ms/rays", 1000 * totals->scans / steps);
	printf("%-14s %016" PRIx64 "\n", "hash of rays", sum->hash);
}

int run_command(const Options* options)
{
	Scene* scene = open_scene(options, options->arguments[0]);
	if (!scene)
		return EXIT_BAD;
	Simulation simulation;
	Outputs outputs;
	Totals totals = {0};
	uint64_t hash = 0;
	int steps = options_steps(options, scene);
	Options drawn;
	int code = outputs_begin(&outputs, options, &drawn);
	if (code == EXIT_GOOD)
		code = simulation_open(&drawn, scene, true, &simulation);
	if (code != EXIT_GOOD)
		outputs_close(&outputs, NULL, code);
	else
	{
		code = outputs_open(&outputs, &simulation);
		if (code == EXIT_GOOD)
			code = take_steps(&simulation, &outputs, steps, &totals);
		if (code == EXIT_GOOD)
			code = report(simulation.pipeline->hash(&simulation, &hash));
		code = outputs_close(&outputs, &simulation, code);
		if (code == EXIT_GOOD)
			print_table(&simulation, &totals, steps, hash);
		simulation_close(&simulation);
	}
	scene_free(scene);
	return code;
}

int hash_command(const Options* options)
{
	Scene* scene = open_scene(options, options->arguments[0]);
	if (!scene)
		return EXIT_BAD;
	Simulation simulation;
	uint64_t hash = 0;
	int code = simulation_open(options, scene, false, &simulation);
	if (code == EXIT_GOOD)
	{
		scree_status status = SCREE_OK;
		int steps = options_steps(options, scene);
		for (int step = 0; step < steps && status == SCREE_OK; ++step)
			status = simulation_step(&simulation);
		if (status == SCREE_OK)
			status = simulation.pipeline->hash(&simulation, &hash);
		code = report(status);
		simulation_close(&simulation);
	}
	if (code == EXIT_GOOD)
		printf("%016" PRIx64 "\n", hash);
	scene_free(scene);
	return code;
}
