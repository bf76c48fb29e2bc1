// SPDX-License-Identifier: MIT
// figure.c -- scree bench figure5 and figure6: what the paper's two figures of measurements show, measured again.
//
// Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines. Figure 5: processing time over the
// number of bodies, on the CPU and on OpenCL. Figure 6: share of each stage in the time at 100 bodies. Here the paper's
// pipeline stands beside ours, and both go on to a million bodies; where a step would take too long, the row says how
// long.
//
// The paper does not say what its scene was, but that detection took most of the time "under normal conditions", and
// that many contacts, as of stacked bodies, move the bottleneck to resolution. So there are two scenes: boxes that
// drift, with few contacts, and pyramids of ten boxes.
//
// Every run begins with one second of the world's time that is not measured, for all sizes, pipelines and devices the
// same: before that, bodies that drift have not met. It is simulated by our own pipeline, because the paper's would
// need minutes for it where a step takes seconds. All devices of a pipeline must have the same hash after the same
// steps.
#include "figure.h"
#include "commands.h"
#include "csv.h"
#include "record.h"
#include "report.h"
#include "scene/load.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WARM_UP    1.0    // s of the world's time; contacts a body in drift are steady from here on (docs/paper.md)
#define WARM_LIMIT 1.0    // s that the CPU may take for it; beyond, the GPU does it and the world moves
#define SETTLE     2      // steps of the pipeline itself before those that count: kernels are built, buffers grow
#define STEPS      40     // that count, in a run that is not cut short
#define FEWEST     3      // counting steps, but one is enough where a run takes longer than LONG_LIMIT
#define TIME_LIMIT 0.3    // s of counting steps, after which a run ends
#define LONG_LIMIT 3.0    // s
#define ROW_LIMIT  0.5    // s: a size that took longer on a device is not repeated there
#define FIGURE5_MS 1000.0 // a step may be expected to take, ms; else it is not run
#define FIGURE6_MS 30000.0

const char* const figure_scenes[FIGURE_SCENES] = {"drift", "pyramids"};
const char* const figure_pipelines[FIGURE_PIPELINES] = {"paper", "scree"};
static const PipelineChoice pipelines[FIGURE_PIPELINES] = {PIPELINE_PAPER, PIPELINE_SOFT};

#define STAGE_NAME(name) #name,
const char* const figure_stages[FIGURE_STAGE_COUNT] = {FIGURE_STAGES(STAGE_NAME)};

typedef struct // a pipeline on a device
{
	int pipeline; // of figure_pipelines
	FigurePlace place;
	const char* device; // as for --device
	int threads;        // as for --threads
	char label[160];    // of the device, in the CSV
	int threads_used;
	double bodies, ms; // of its last row
	bool ended;        // larger sizes would take too long
} Curve;

typedef struct // what all devices share at one size
{
	uint64_t hash;
	const char* device; // that left it; null before the first
} Plan;

typedef struct
{
	const Options* options;
	FILE* csv;
	int number; // 5 or 6
	int scene;
	char settings[64]; // of the scene, as in the CSV
	const char* gpu;   // as for --device; null for none
	double begin;      // s
	int rows;
} Figure;

typedef struct
{
	Record* records; // of counting steps, repeat after repeat
	int count, repeats;
	double least, most; // median step of the fastest and of the slowest repeat, ms
	uint64_t hash;      // after the first counting step
} Rows;

typedef struct // settings that give a scene its size
{
	const char* names[3];
	int values[3];
	int count, bodies; // walls and shelves are bodies, too
} Size;

// As near to a number of bodies as the scene can be; pyramids in about as many columns as rows.
static Size choose_size(int scene, int bodies)
{
	if (scene == 0)
		return (Size){{"boxes"}, {bodies - 4}, 1, bodies};
	Size best = {{"base", "columns", "rows"}, {4, 1, 1}, 3, 11};
	int square = (int)sqrt(bodies / 10.0);
	for (int rows = square; 2 * rows > square; --rows)
		for (int columns = rows; columns <= 2 * square + 10; ++columns)
			if (abs(rows * (10 * columns + 1) - bodies) < abs(best.bodies - bodies))
			{
				best.values[1] = columns;
				best.values[2] = rows;
				best.bodies = rows * (10 * columns + 1);
			}
	return best;
}

// The options with the settings of a size, whose values lie in text.
static Options with_size(const Options* options, const Size* size, char text[3][16])
{
	Options sized = *options;
	for (int k = 0; k < size->count; ++k)
	{
		snprintf(text[k], sizeof text[k], "%d", size->values[k]);
		sized.settings[sized.setting_count++] = (SceneSetting){size->names[k], text[k]};
	}
	return sized;
}

static double mean(const Rows* rows, double (*value)(const Record* record, int argument))
{
	double sum = 0;
	for (int k = 0; k < rows->count; ++k)
		sum += value(&rows->records[k], 0);
	return sum / rows->count;
}

static void say_row(Figure* figure, const Curve* curve, int bodies)
{
	++figure->rows;
	fprintf(stderr, "%5.1f s: %s, %d bodies, %s, %s", seconds_now() - figure->begin, figure_scenes[figure->scene],
	        bodies, figure_pipelines[curve->pipeline], curve->label);
	if (curve->place != ON_OPENCL)
		fprintf(stderr, ", %d thread%s", curve->threads_used, curve->threads_used == 1 ? "" : "s");
}

static void print_row(Figure* figure, Curve* curve, const Rows* rows)
{
	const Pipeline* f = choose_pipeline(pipelines[curve->pipeline]);
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
	say_row(figure, curve, bodies);
	fprintf(stderr, ": %.3f ms a step, %.4f contacts a body\n", curve->ms, contacts / bodies);
}

// A row of no steps: what a step would take, from the last size that was run. The paper tests every pair, and goes
// through all contacts after each resolution.
static void print_estimate(Figure* figure, const Curve* curve, int bodies, double ms)
{
	fprintf(figure->csv, "%s,%s,%s,%s,%d,%d,,,0,0,%.0f,,", figure_scenes[figure->scene], figure->settings,
	        figure_pipelines[curve->pipeline], curve->label, curve->threads_used, bodies, ms);
	for (int s = 0; s < FIGURE_STAGE_COUNT && figure->number == 6; ++s)
		fprintf(figure->csv, ",");
	fprintf(figure->csv, ",,\n");
	say_row(figure, curve, bodies);
	fprintf(stderr, ": not run, up to %.0f ms a step\n", ms);
}

static double estimate(const Curve* curve, int bodies)
{
	double growth = curve->bodies > 0 ? bodies / curve->bodies : 0;
	return curve->ms * (pipelines[curve->pipeline] == PIPELINE_PAPER ? growth * growth : growth);
}

// Where and by how many steps a run is warmed up. The paper's pipeline takes over from all threads of the CPU. Ours is
// warmed up where it is measured, unless that would take the CPU too long: the bits are the same.
static void plan_warm_up(const Figure* figure, const Curve* curve, const Scene* scene, double expected,
                         Options* options)
{
	options->warm_up = (int)lround(WARM_UP / (double)scene->dt);
	options->threads = curve->threads;
	if (pipelines[curve->pipeline] == PIPELINE_PAPER)
	{
		options->threads = figure->options->threads;
		options->warm_device = "cpu";
	}
	else if (curve->place != ON_OPENCL && figure->gpu && expected * options->warm_up > 1000 * WARM_LIMIT)
		options->warm_device = figure->gpu;
}

// Takes the steps of one run and records those that count.
static scree_status take_steps(Simulation* simulation, int most, Rows* rows)
{
	int before = rows->count;
	double all = 0, counting = 0; // s
	scree_status status = SCREE_OK;
	for (int step = 0; step < SETTLE + most && status == SCREE_OK; ++step)
	{
		int counted = rows->count - before;
		if ((counted >= FEWEST && counting > TIME_LIMIT) || (counted > 0 && all > LONG_LIMIT))
			break;
		Record* record = &rows->records[rows->count];
		status = record_step(simulation, record);
		all += 1e-3 * (double)record->milliseconds;
		if (step < SETTLE)
			continue;
		counting += 1e-3 * (double)record->milliseconds;
		++rows->count;
		// where more steps follow, there are not equally many on all devices
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

static int check_hash(const Figure* figure, const Curve* curve, Plan* plan, uint64_t hash)
{
	if (!plan->device)
	{
		plan->hash = hash;
		plan->device = curve->device;
	}
	if (plan->hash == hash)
		return EXIT_GOOD;
	fprintf(stderr, "scree bench: %s %s, %s: the hash is %016" PRIx64 " on %s, but was %016" PRIx64 " on %s before\n",
	        figure_scenes[figure->scene], figure->settings, figure_pipelines[curve->pipeline], hash, curve->label,
	        plan->hash, plan->device);
	return EXIT_FAILED;
}

static int run_once(const Figure* figure, Curve* curve, const Options* options, const Scene* scene, int most,
                    Plan* plan, Rows* rows)
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
	return code == EXIT_GOOD ? check_hash(figure, curve, plan, rows->hash) : code;
}

static int measure(Figure* figure, Curve* curve, Plan* plan, const Options* sized, double expected)
{
	Options options = *sized;
	options.pipeline = pipelines[curve->pipeline];
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
		code = run_once(figure, curve, &options, scene, most, plan, &all);
		++all.repeats;
	}
	if (code == EXIT_GOOD)
		print_row(figure, curve, &all);
	free(all.records);
	scene_free(scene);
	return code;
}

// Of both pipelines a curve on one thread of the CPU and one on OpenCL, of ours one on all threads; of a device that is
// not there none. --device cpu leaves out OpenCL, and --threads 1 what more threads would do.
static int curves_of(Figure* figure, Curve curves[FIGURE_PIPELINES * FIGURE_PLACES])
{
	const Options* options = figure->options;
	scree_device devices[16];
	int found = 0, cores = 1;
	bool alone = options->device && strcmp(options->device, "cpu") == 0, far = false;
	bool named = options->device && strncmp(options->device, "opencl", 6) == 0;
	if (scree_devices_get(devices, 16, &found) == SCREE_OK)
		for (int k = 0; k < found && k < 16; ++k)
		{
			bool opencl = strncmp(devices[k].name, "opencl", 6) == 0;
			far = far || opencl;
			cores = opencl ? cores : devices[k].units;
		}
	if (!far && !alone)
		fprintf(stderr, "scree bench: no curves of OpenCL: %s\n", scree_opencl_remedy());
	figure->gpu = !far || alone ? NULL : named ? options->device : "opencl";
	int count = 0, threads = options->threads > 0 ? options->threads : cores;
	for (int pipeline = 0; pipeline < FIGURE_PIPELINES; ++pipeline)
	{
		bool paper = pipelines[pipeline] == PIPELINE_PAPER;
		curves[count++] = (Curve){.pipeline = pipeline, .place = ON_ONE_THREAD, .device = "cpu", .threads = 1};
		if (!paper && threads > 1)
			curves[count++] = (Curve){.pipeline = pipeline, .place = ON_THREADS, .device = "cpu", .threads = threads};
		if (figure->gpu)
			curves[count++] = (Curve){.pipeline = pipeline, .place = ON_OPENCL, .device = figure->gpu};
	}
	return count;
}

// All curves of one scene, size by size.
static int measure_scene(Figure* figure, const int* sizes, int size_count)
{
	Curve curves[FIGURE_PIPELINES * FIGURE_PLACES];
	int count = curves_of(figure, curves), code = EXIT_GOOD, before = 0;
	double limit = figure->number == 5 ? FIGURE5_MS : FIGURE6_MS;
	for (int k = 0; k < size_count && code == EXIT_GOOD; ++k)
	{
		Size size = choose_size(figure->scene, sizes[k]);
		Plan plan = {0};
		char values[3][16];
		Options sized = with_size(figure->options, &size, values);
		settings_text(&sized, figure->settings, sizeof figure->settings);
		for (int c = 0; c < count && code == EXIT_GOOD && size.bodies > before; ++c)
		{
			if (c > 0 && curves[c].pipeline != curves[c - 1].pipeline)
				plan = (Plan){0};
			double expected = estimate(&curves[c], size.bodies);
			curves[c].ended = curves[c].ended || expected > limit;
			if (curves[c].ended)
				print_estimate(figure, &curves[c], size.bodies, expected);
			else
				code = measure(figure, &curves[c], &plan, &sized, expected);
		}
		before = size.bodies;
	}
	return code;
}

static int write_csv(const Options* options, const char* csv, int number)
{
	static const int over[] = {25,  50,  75,   100,  125,  150,   175,   200,   225,    250,    256,    264,
	                           275, 300, 325,  350,  375,  400,   425,   450,   475,    500,    512,    528,
	                           550, 700, 1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000};
	static const int at[] = {100, 10000, 1000000};
	const int* sizes = number == 5 ? over : at;
	int count = number == 5 ? (int)(sizeof over / sizeof *over) : (int)(sizeof at / sizeof *at), code = EXIT_GOOD;
	while (count > 1 && options->limit > 0 && sizes[count - 1] > options->limit)
		--count;
	Figure figure = {.options = options, .number = number, .csv = fopen(csv, "w"), .begin = seconds_now()};
	if (!figure.csv)
	{
		fprintf(stderr, "scree bench: cannot write %s: %s\n", csv, strerror(errno));
		return EXIT_FAILED;
	}
	fputs(
	    "scene,settings,pipeline,device,threads,bodies,contacts,contacts_a_body,steps,repeats,ms_step,ms_least,ms_most",
	    figure.csv);
	for (int k = 0; k < FIGURE_STAGE_COUNT && number == 6; ++k)
		fprintf(figure.csv, ",ms_%s", figure_stages[k]);
	fputs(",penetration,hash\n", figure.csv);
	for (; figure.scene < FIGURE_SCENES && code == EXIT_GOOD; ++figure.scene)
		code = measure_scene(&figure, sizes, count);
	bool bad = ferror(figure.csv) != 0;
	if ((fclose(figure.csv) != 0 || bad) && code == EXIT_GOOD)
	{
		fprintf(stderr, "scree bench: cannot write %s: %s\n", csv, strerror(errno));
		code = EXIT_FAILED;
	}
	if (code == EXIT_GOOD)
		fprintf(stderr, "%s: %d rows in %.0f s\n", csv, figure.rows, seconds_now() - figure.begin);
	return code;
}

static int figure(const Options* options, int number)
{
	const char* csv = number == 5 ? "figure5.csv" : "figure6.csv";
	int code = options->draw ? EXIT_GOOD : write_csv(options, csv, number);
	return code == EXIT_GOOD ? plot_figure(options->draw ? options->draw : csv, number) : code;
}

int figure5_command(const Options* options) { return figure(options, 5); }
int figure6_command(const Options* options) { return figure(options, 6); }
