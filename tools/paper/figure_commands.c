// SPDX-License-Identifier: MIT
// figure_commands.c -- scree_paper figure5 and figure6: repeats the measurements of two figures of the paper.
//
// Paper: Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines. Figure 5 shows the time of a
// step over the number of bodies, on the CPU and on OpenCL. Figure 6 shows the share of each stage in the time, at 100
// bodies. Here both figures have the paper's pipeline and Scree's, and go up to a million bodies. If a step would take
// too long, the row has an estimate.
//
// The paper does not describe its scene. It says that detection took most of the time "under normal conditions", and
// that many contacts, as in stacks, move the bottleneck to resolution. So there are two scenes: drifting boxes with few
// contacts, and pyramids of ten boxes.
//
// Every run begins with one second of simulated time that is not measured, because at first the drifting bodies have
// not met. This is the same for all sizes, pipelines and devices. Scree simulates this second, because the paper's
// pipeline would need minutes if a step takes seconds. All devices of a pipeline must have the same hash after the same
// steps.
#include "cli/common/csv.h"
#include "tools/common/clock.h"
#include "tools/paper/curve.h"
#include "tools/paper/paper_commands.h"
#include "tools/paper/paper_options.h"
#include "tools/paper/plot.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FIGURE5_MS 1000.0 // Expected ms of a step above which a size is not measured.
#define FIGURE6_MS 30000.0

typedef struct // a size of a scene, as settings of its parameters
{
	const char* names[3];
	int values[3];
	int count, bodies; // number of settings; number of bodies, including walls and shelves
} Size;

// Returns the size of a scene that is nearest to a number of bodies. Pyramids have about as many columns as rows.
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

// Returns the options with the settings of a size added. The values of the settings are stored in `text`.
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

// Lists the curves of the devices that were found, and returns their number. Each pipeline has a curve on one thread of
// the CPU and a curve on OpenCL; Scree also has a curve on all threads. --device cpu leaves out OpenCL, --threads 1 the
// curve on all threads.
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
			cores = opencl ? cores : devices[k].compute_units;
		}
	if (!far && !alone)
		fprintf(stderr, "scree_paper: no curves of OpenCL: %s\n", scree_opencl_hint());
	figure->gpu = !far || alone ? NULL : named ? options->device : "opencl";
	int count = 0, threads = options->threads > 0 ? options->threads : cores;
	for (FigurePipeline pipeline = PAPER_PIPELINE; pipeline < FIGURE_PIPELINES; ++pipeline)
	{
		curves[count++] = (Curve){.pipeline = pipeline, .place = ON_ONE_THREAD, .device = "cpu", .threads = 1};
		if (pipeline != PAPER_PIPELINE && threads > 1)
			curves[count++] = (Curve){.pipeline = pipeline, .place = ON_THREADS, .device = "cpu", .threads = threads};
		if (figure->gpu)
			curves[count++] = (Curve){.pipeline = pipeline, .place = ON_OPENCL, .device = figure->gpu};
	}
	return count;
}

// Measures all curves of one scene, size by size. Returns an exit code.
static int measure_scene(Figure* figure, const int* sizes, int size_count)
{
	Curve curves[FIGURE_PIPELINES * FIGURE_PLACES];
	int count = curves_of(figure, curves), code = EXIT_GOOD, before = 0;
	double limit = figure->number == 5 ? FIGURE5_MS : FIGURE6_MS;
	for (int k = 0; k < size_count && code == EXIT_GOOD; ++k)
	{
		Size size = choose_size(figure->scene, sizes[k]);
		CommonHash common = {0};
		char values[3][16];
		Options sized = with_size(figure->options, &size, values);
		settings_text(&sized, figure->settings, sizeof figure->settings);
		for (int c = 0; c < count && code == EXIT_GOOD && size.bodies > before; ++c)
		{
			if (c > 0 && curves[c].pipeline != curves[c - 1].pipeline)
				common = (CommonHash){0};
			double expected = curve_estimate(&curves[c], size.bodies);
			curves[c].ended = curves[c].ended || expected > limit;
			if (curves[c].ended)
				curve_print_estimate(figure, &curves[c], size.bodies, expected);
			else
				code = curve_measure(figure, &curves[c], &common, &sized, expected);
		}
		before = size.bodies;
	}
	return code;
}

static int write_csv(const PaperOptions* options, const char* csv, int number)
{
	static const int over[] = {25,  50,  75,   100,  125,  150,   175,   200,   225,    250,    256,    264,
	                           275, 300, 325,  350,  375,  400,   425,   450,   475,    500,    512,    528,
	                           550, 700, 1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000};
	static const int at[] = {100, 10000, 1000000};
	const int* sizes = number == 5 ? over : at;
	int count = number == 5 ? (int)(sizeof over / sizeof *over) : (int)(sizeof at / sizeof *at), code = EXIT_GOOD;
	while (count > 1 && options->limit > 0 && sizes[count - 1] > options->limit)
		--count;
	Figure figure = {.options = &options->common, .number = number, .csv = fopen(csv, "w"), .begin = seconds_now()};
	if (!figure.csv)
	{
		fprintf(stderr, "scree_paper: cannot write %s: %s\n", csv, strerror(errno));
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
		fprintf(stderr, "scree_paper: cannot write %s: %s\n", csv, strerror(errno));
		code = EXIT_FAILED;
	}
	if (code == EXIT_GOOD)
		fprintf(stderr, "%s: %d rows in %.0f s\n", csv, figure.rows, seconds_now() - figure.begin);
	return code;
}

static int measure_and_plot(const Options* common, int number)
{
	const PaperOptions* options = (const PaperOptions*)common;
	const char* csv = number == 5 ? "figure5.csv" : "figure6.csv";
	int code = options->draw ? EXIT_GOOD : write_csv(options, csv, number);
	return code == EXIT_GOOD ? plot_figure(options->draw ? options->draw : csv, number) : code;
}

int figure5_command(const Options* options) { return measure_and_plot(options, 5); }
int figure6_command(const Options* options) { return measure_and_plot(options, 6); }
