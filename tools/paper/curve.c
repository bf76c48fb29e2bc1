// SPDX-License-Identifier: MIT
// curve.c -- measures a pipeline on a device with a world of one size: a point on a curve of a figure.
#include "tools/paper/curve.h"
#include "cli/common/csv.h"
#include "cli/common/library_error.h"
#include "scene/load.h"
#include "tools/common/clock.h"
#include "tools/paper/paper_player.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// s of simulated time before a measurement; after it, the number of contacts per body in the scene drift is steady
// (docs/measurements/paper.md)
#define WARM_UP 1.0
// s: maximum duration of a warm-up on the CPU; a longer one runs on the GPU, and the world then migrates to the CPU
#define WARM_LIMIT 1.0
#define SETTLE     2   // steps of the pipeline before the measured steps: kernels are compiled, buffers grow
#define STEPS      40  // measured steps of a repeat, unless a time limit ends it
#define FEWEST     3   // minimum number of measured steps in a repeat; 1 if the repeat takes longer than LONG_LIMIT
#define TIME_LIMIT 0.3 // s of measured steps, after which a repeat ends
#define LONG_LIMIT 3.0 // s of all steps, measured or not, after which a repeat ends
#define ROW_LIMIT  0.5 // s: after this time no further repeat begins

typedef struct
{
	Record* records; // measured steps of all repeats, in order
	int count, repeats;
	double least, most; // ms: median of the steps of a repeat, for the fastest and the slowest repeat
	uint64_t hash;      // hash after the first measured step
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
	const char* const* stages = curve->pipeline == PAPER_PIPELINE ? paper_stages : stage_names;
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
		while (k < STAGE_TIMES && strcmp(stages[k], figure_stages[s]) != 0)
			++k;
		fprintf(figure->csv, ",%.4f", k < STAGE_TIMES ? median(rows->records, rows->count, stage_of, k) : 0.0);
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

// Estimates the ms of a step. The time of Scree's pipeline grows with the number of bodies. The paper's pipeline tests
// every pair of bodies, and goes through all contacts after each resolution, so its time grows with the square of this
// number.
double curve_estimate(const Curve* curve, int bodies)
{
	double growth = curve->bodies > 0 ? bodies / curve->bodies : 0;
	return curve->ms * (curve->pipeline == PAPER_PIPELINE ? growth * growth : growth);
}

// Returns the options of the warm-up, whose steps are always steps of Scree. Before the paper's pipeline they run on
// the CPU. Before Scree's pipeline they run on the measured device, or on the GPU if the CPU would need too long: the
// bits are the same.
static Options plan_warm_up(const Figure* figure, const Curve* curve, const Options* sized, int steps, double expected)
{
	Options options = *sized;
	options.device = curve->device;
	options.threads = curve->threads;
	if (curve->pipeline == PAPER_PIPELINE)
	{
		options.threads = figure->options->threads;
		options.device = "cpu";
	}
	else if (curve->place != ON_OPENCL && figure->gpu && expected * steps > 1000 * WARM_LIMIT)
		options.device = figure->gpu;
	return options;
}

// Opens a world with the options of the warm-up, warms it up, and moves it to the device of the curve. Returns an exit
// code. The caller closes the run, also after a failure.
static int open_run(const Curve* curve, const Options* options, const Scene* scene, int steps, bool timings,
                    PaperPlayer* run)
{
	*run = (PaperPlayer){0};
	int code = open_player(options, scene, timings, &run->player);
	if (code != EXIT_GOOD)
		return code;
	scree_status status = SCREE_OK;
	for (int step = 0; step < steps && status == SCREE_OK; ++step)
		status = player_step(&run->player);
	scree_world* world = run->player.world;
	if (status == SCREE_OK && curve->pipeline == PAPER_PIPELINE)
		status = paper_create(world, curve->device, options->allow_unequal_bits, &run->paper);
	else if (status == SCREE_OK && strcmp(options->device, curve->device) != 0)
		status = scree_world_move(world, curve->device);
	return report(status);
}

static scree_status record_run(PaperPlayer* run, Record* record)
{
	return run->paper ? paper_record_step(run, record) : record_step(&run->player, record);
}

static scree_status hash_run(const PaperPlayer* run, uint64_t* hash)
{
	if (!run->paper)
		return scree_world_get_hash(run->player.world, hash);
	*hash = paper_hash(run->paper);
	return SCREE_OK;
}

// Takes the steps of one repeat, with at most `most` measured steps, and adds the measured steps to rows.
static scree_status take_steps(PaperPlayer* run, int most, Rows* rows)
{
	int before = rows->count;
	double all = 0, measured = 0; // s: time of all steps, and of measured steps
	scree_status status = SCREE_OK;
	for (int step = 0; step < SETTLE + most && status == SCREE_OK; ++step)
	{
		int counted = rows->count - before;
		if ((counted >= FEWEST && measured > TIME_LIMIT) || (counted > 0 && all > LONG_LIMIT))
			break;
		Record* record = &rows->records[rows->count];
		status = record_run(run, record);
		all += 1e-3 * (double)record->milliseconds;
		if (step < SETTLE)
			continue;
		measured += 1e-3 * (double)record->milliseconds;
		++rows->count;
		// hash after the first measured step, because only this step is taken on every device
		if (step == SETTLE && status == SCREE_OK)
			status = hash_run(run, &rows->hash);
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
	fprintf(stderr, "scree_paper: %s %s, %s: the hash is %016" PRIx64 " on %s, but was %016" PRIx64 " on %s before\n",
	        figure_scenes[figure->scene], figure->settings, figure_pipelines[curve->pipeline], hash, curve->label,
	        common->hash, common->device);
	return EXIT_FAILED;
}

// Copies the device and the number of threads of a run to its curve.
static void label_curve(const PaperPlayer* run, Curve* curve)
{
	const scree_world* world = run->player.world;
	snprintf(curve->label, sizeof curve->label, "%s",
	         run->paper ? paper_device(run->paper) : scree_world_get_device(world));
	csv_cell(curve->label);
	curve->threads_used = run->paper ? 1 : scree_world_get_threads(world);
}

static int run_once(const Figure* figure, Curve* curve, const Options* options, const Scene* scene, int warm_up,
                    int most, Rows* rows)
{
	PaperPlayer run;
	int code = open_run(curve, options, scene, warm_up, figure->number == 6, &run);
	if (code == EXIT_GOOD)
		code = report(take_steps(&run, most, rows));
	if (code == EXIT_GOOD)
		label_curve(&run, curve);
	paper_player_close(&run);
	return code;
}

int curve_measure(Figure* figure, Curve* curve, CommonHash* common, const Options* sized, double expected)
{
	Scene* scene = open_scene(sized, figure_scenes[figure->scene]);
	if (!scene)
		return EXIT_BAD;
	int warm_up = (int)lround(WARM_UP / (double)scene->dt);
	Options options = plan_warm_up(figure, curve, sized, warm_up, expected);
	int most = options.steps > 0 ? options.steps : STEPS, code = EXIT_GOOD;
	Rows all = {.records = malloc(((size_t)most * (size_t)options.repeats + 1) * sizeof(Record))};
	if (!all.records)
	{
		fprintf(stderr, "scree_paper: out of memory for %d steps\n", most);
		code = EXIT_FAILED;
	}
	double begin = seconds_now();
	while (code == EXIT_GOOD && all.repeats < options.repeats &&
	       (all.repeats == 0 || seconds_now() - begin < ROW_LIMIT))
	{
		code = run_once(figure, curve, &options, scene, warm_up, most, &all);
		if (code == EXIT_GOOD)
			code = check_hash(figure, curve, common, all.hash);
		++all.repeats;
	}
	if (code == EXIT_GOOD)
		print_row(figure, curve, &all);
	free(all.records);
	scene_free(scene);
	return code;
}
