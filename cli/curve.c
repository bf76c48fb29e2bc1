// SPDX-License-Identifier: MIT
// curve.c -- measures one curve of a figure, a pipeline on a device, at one size.
#include "curve.h"
#include "csv.h"
#include "library_error.h"
#include "scene/load.h"
#include "step_record.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WARM_UP    1.0 // s of the world's time, after which contacts a body in drift are steady (docs/paper.md)
#define WARM_LIMIT 1.0 // s of CPU time for it; if it would take longer, the GPU does it and the world moves
#define SETTLE     2   // steps of the pipeline before the measured ones: kernels are built, buffers grow
#define STEPS      40  // measured steps of a run that no time limit ends
#define FEWEST     3   // measured steps at least; 1 in a run that takes longer than LONG_LIMIT
#define TIME_LIMIT 0.3 // s of measured steps, after which a run ends
#define LONG_LIMIT 3.0 // s
#define ROW_LIMIT  0.5 // s of all repeats: no repeat begins after it

typedef struct
{
	Record* records; // of measured steps, repeat after repeat
	int count, repeats;
	double least, most; // median step of the fastest and of the slowest repeat, ms
	uint64_t hash;      // after the first measured step
} Rows;

static double mean(const Rows* rows, double (*value)(const Record* record, int argument))
{
	double sum = 0;
	for (int k = 0; k < rows->count; ++k)
		sum += value(&rows->records[k], 0);
	return sum / rows->count;
}

static void print_progress(Figure* figure, const Curve* curve, int bodies)
{
	++figure->rows;
	fprintf(stderr, "%5.1f s: %s, %d bodies, %s, %s", seconds_now() - figure->begin, figure_scenes[figure->scene],
	        bodies, figure_pipelines[curve->pipeline], curve->label);
	if (curve->place != ON_OPENCL)
		fprintf(stderr, ", %d thread%s", curve->threads_used, curve->threads_used == 1 ? "" : "s");
}

static void print_row(Figure* figure, Curve* curve, const Rows* rows)
{
	const Pipeline* f = choose_pipeline(figure_choices[curve->pipeline]);
	int bodies = rows->records[rows->count - 1].counters.bodies;
	double contacts = mean(rows, touching_of);
	curve->ms = median(rows->records, rows->count, step_of, 0);
	curve->bodies = bodies;
	fprintf(figure->csv, "%s,%s,%s,%s,%d,%d,%.1f,%.4f,%d,%d,%.4f,%.4f,%.4f", figure_scenes[figure->scene],
	        figure->settings, figure_pipelines[curve->pipeline], curve->label, curve->threads_used, bodies, contacts,
	        contacts / bodies, rows->count / rows->repeats, rows->repeats, curve->ms, rows->least, rows->most);
	for (int s = 0; s < FIGURE_STAGE_COUNT && figure->number == 6; ++s)
	{
		int k = 0;
		while (k < STAGE_COLUMNS && strcmp(f->stages[k], figure_stages[s]) != 0)
			++k;
		fprintf(figure->csv, ",%.4f", k < STAGE_COLUMNS ? median(rows->records, rows->count, stage_of, k) : 0.0);
	}
	fprintf(figure->csv, ",%.5f,%016" PRIx64 "\n", (double)deepest(rows->records, rows->count), rows->hash);
	fflush(figure->csv);
	print_progress(figure, curve, bodies);
	fprintf(stderr, ": %.3f ms a step, %.4f contacts a body\n", curve->ms, contacts / bodies);
}

void curve_print_estimate(Figure* figure, const Curve* curve, int bodies, double ms)
{
	fprintf(figure->csv, "%s,%s,%s,%s,%d,%d,,,0,0,%.0f,,", figure_scenes[figure->scene], figure->settings,
	        figure_pipelines[curve->pipeline], curve->label, curve->threads_used, bodies, ms);
	for (int s = 0; s < FIGURE_STAGE_COUNT && figure->number == 6; ++s)
		fprintf(figure->csv, ",");
	fprintf(figure->csv, ",,\n");
	print_progress(figure, curve, bodies);
	fprintf(stderr, ": not run, up to %.0f ms a step\n", ms);
}

// The paper's pipeline tests every pair of bodies and goes through all contacts after each resolution: its time grows with the
// square of the bodies.
double curve_estimate(const Curve* curve, int bodies)
{
	double growth = curve->bodies > 0 ? bodies / curve->bodies : 0;
	return curve->ms * (figure_choices[curve->pipeline] == PIPELINE_PAPER ? growth * growth : growth);
}

// Chooses steps and device of the warm-up. The paper's pipeline is warmed up on all threads of the CPU, ours on the device that
// is measured. If the CPU would need too long the GPU does it, because the bits are the same.
static void plan_warm_up(const Figure* figure, const Curve* curve, const Scene* scene, double expected,
                         Options* options)
{
	options->warm_up = (int)lround(WARM_UP / (double)scene->dt);
	options->threads = curve->threads;
	if (figure_choices[curve->pipeline] == PIPELINE_PAPER)
	{
		options->threads = figure->options->threads;
		options->warm_device = "cpu";
	}
	else if (curve->place != ON_OPENCL && figure->gpu && expected * options->warm_up > 1000 * WARM_LIMIT)
		options->warm_device = figure->gpu;
}

// Takes the steps of one run and records the measured ones.
static scree_status take_steps(Simulation* simulation, int most, Rows* rows)
{
	int before = rows->count;
	double all = 0, measured = 0; // s
	scree_status status = SCREE_OK;
	for (int step = 0; step < SETTLE + most && status == SCREE_OK; ++step)
	{
		int counted = rows->count - before;
		if ((counted >= FEWEST && measured > TIME_LIMIT) || (counted > 0 && all > LONG_LIMIT))
			break;
		Record* record = &rows->records[rows->count];
		status = record_step(simulation, record);
		all += 1e-3 * (double)record->milliseconds;
		if (step < SETTLE)
			continue;
		measured += 1e-3 * (double)record->milliseconds;
		++rows->count;
		// only the first measured step is one that all devices take
		if (step == SETTLE && status == SCREE_OK)
			status = simulation->pipeline->hash(simulation, &rows->hash);
	}
	if (status != SCREE_OK)
		return status;
	double middle = median(rows->records + before, rows->count - before, step_of, 0);
	rows->least = before == 0 ? middle : fmin(rows->least, middle);
	rows->most = fmax(rows->most, middle);
	return status;
}

static int check_hash(const Figure* figure, const Curve* curve, CommonHash* common, uint64_t hash)
{
	if (!common->device)
	{
		common->hash = hash;
		common->device = curve->device;
	}
	if (common->hash == hash)
		return EXIT_GOOD;
	fprintf(stderr, "scree bench: %s %s, %s: the hash is %016" PRIx64 " on %s, but was %016" PRIx64 " on %s before\n",
	        figure_scenes[figure->scene], figure->settings, figure_pipelines[curve->pipeline], hash, curve->label,
	        common->hash, common->device);
	return EXIT_FAILED;
}

static int run_once(const Figure* figure, Curve* curve, const Options* options, const Scene* scene, int most,
                    CommonHash* common, Rows* rows)
{
	Simulation simulation;
	int code = simulation_open(options, scene, figure->number == 6, &simulation);
	if (code != EXIT_GOOD)
		return code;
	code = report(take_steps(&simulation, most, rows));
	snprintf(curve->label, sizeof curve->label, "%s", simulation.pipeline->device(&simulation));
	csv_cell(curve->label);
	curve->threads_used = simulation.pipeline->one_thread ? 1 : scree_world_get_threads(simulation.world);
	simulation_close(&simulation);
	return code == EXIT_GOOD ? check_hash(figure, curve, common, rows->hash) : code;
}

int curve_measure(Figure* figure, Curve* curve, CommonHash* common, const Options* sized, double expected)
{
	Options options = *sized;
	options.pipeline = figure_choices[curve->pipeline];
	options.device = curve->device;
	Scene* scene = open_scene(&options, figure_scenes[figure->scene]);
	if (!scene)
		return EXIT_BAD;
	plan_warm_up(figure, curve, scene, expected, &options);
	int most = options.steps > 0 ? options.steps : STEPS, code = EXIT_GOOD;
	Rows all = {.records = malloc(((size_t)most * (size_t)options.repeats + 1) * sizeof(Record))};
	if (!all.records)
	{
		fprintf(stderr, "scree bench: out of memory for %d steps\n", most);
		code = EXIT_FAILED;
	}
	double begin = seconds_now();
	while (code == EXIT_GOOD && all.repeats < options.repeats &&
	       (all.repeats == 0 || seconds_now() - begin < ROW_LIMIT))
	{
		code = run_once(figure, curve, &options, scene, most, common, &all);
		++all.repeats;
	}
	if (code == EXIT_GOOD)
		print_row(figure, curve, &all);
	free(all.records);
	scene_free(scene);
	return code;
}
