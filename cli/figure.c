// SPDX-License-Identifier: MIT
// figure.c -- scree bench figure5 and figure6: the two figures of measurements in the paper, drawn again.
//
// Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines. Figure 5: processing time over the number
// of bodies, on the CPU and on OpenCL. Figure 6: share of each stage in the time at 100 bodies. Here the paper's pipeline
// stands beside ours, and both go on to a million bodies, as far as a step takes less than STEP_LIMIT.
//
// The scene is pyramids of ten boxes: stacked, so that there are contacts from the first step on, as many as bodies.
#include "commands.h"
#include "plot.h"
#include "record.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PYRAMID    10      // boxes
#define STEPS      60      // at most, and as many as fit into
#define TIME_LIMIT 2.0     // s, but FEWEST_STEPS
#define STEP_LIMIT 2000.0  // ms: a curve of figure 5 ends where a step takes longer,
#define LONG_LIMIT 30000.0 // and a bar of figure 6 is left out
#define WARM_UP    2       // steps, unless they take so long that it makes no difference
#define FEWEST     5

#define MAX_CURVES 4

// columns of figure 6: the paper's stages, its copies over the bus, and ours
static const char* const stages[] = {"to_device",   "from_device",  "integrate", "transform", "detect",  "resolve",
                                     "broad_phase", "narrow_phase", "color",     "solve",     "finalize"};
#define STAGES ((int)(sizeof stages / sizeof *stages))

typedef struct
{
	PipelineChoice pipeline;
	const char *name, *device; // of the pipeline; as for --device
	double bodies, ms;         // of the last point
	bool ended;
} Curve;

typedef struct
{
	const Options* options;
	FILE* csv;
	bool timings;
	Plot plot;
} Figure;

// whole pyramids, side by side and on top of each other
static void set_bodies(Options* options, int bodies, char values[2][16])
{
	int pyramids = bodies > PYRAMID ? bodies / PYRAMID : 1;
	int columns = (int)ceil(sqrt((double)pyramids));
	snprintf(values[0], 16, "%d", columns);
	snprintf(values[1], 16, "%d", (pyramids + columns - 1) / columns);
	SceneSetting* s = options->settings + options->setting_count;
	s[0] = (SceneSetting){"base", "4"};
	s[1] = (SceneSetting){"columns", values[0]};
	s[2] = (SceneSetting){"rows", values[1]};
	options->setting_count += 3;
}

static void print_row(Figure* figure, Curve* curve, Simulation* simulation, const Record* records, int count,
                      uint64_t hash)
{
	const SimulationFunctions* f = simulation->f;
	char device[160];
	snprintf(device, sizeof device, "%s", scree_world_device(simulation->world));
	for (char* c = device; *c; ++c)
		*c = *c == ',' ? ' ' : *c;
	curve->ms = median(records, count, step_of, 0);
	curve->bodies = records[count - 1].counters.bodies;
	fprintf(figure->csv, "%s,%s,%d,%d,%.0f,%.4f", curve->name, device, records[count - 1].counters.bodies, count,
	        median(records, count, touching_of, 0), curve->ms);
	for (int s = 0; s < STAGES && figure->timings; ++s)
	{
		int k = 0;
		while (k < STAGE_COLUMNS && strcmp(f->stages[k], stages[s]) != 0)
			++k;
		fprintf(figure->csv, ",%.4f", k < STAGE_COLUMNS ? median(records, count, stage_of, k) : 0.0);
	}
	fprintf(figure->csv, ",%.5f,%016" PRIx64 "\n", (double)deepest(records, count), hash);
	fflush(figure->csv);
	fprintf(stderr, "%s on %s, %d bodies: %.3f ms a step\n", curve->name, device, records[count - 1].counters.bodies,
	        curve->ms);
}

static int measure(Figure* figure, Curve* curve, int bodies)
{
	char values[2][16];
	Options options = *figure->options;
	options.pipeline = curve->pipeline;
	options.device = curve->device;
	set_bodies(&options, bodies, values);
	Scene* scene = open_scene(&options, "pyramids");
	if (!scene)
		return EXIT_BAD;
	Simulation simulation;
	int code = simulation_open(&options, scene, figure->timings, &simulation);
	if (code != EXIT_GOOD)
	{
		scene_free(scene);
		return code;
	}
	Record records[STEPS];
	int count = 0, steps = options.steps > 0 && options.steps < STEPS ? options.steps : STEPS;
	uint64_t hash = 0;
	scree_status status = SCREE_OK;
	double begin = seconds_now();
	for (int step = 0; count < steps && status == SCREE_OK; ++step)
	{
		double taken = seconds_now() - begin;
		if ((count >= FEWEST && taken > TIME_LIMIT) || (count > 0 && taken > FEWEST * TIME_LIMIT))
			break;
		status = record_step(&simulation, &records[count]);
		count += step >= WARM_UP || records[count].milliseconds > 1e3 * TIME_LIMIT;
	}
	if (status == SCREE_OK)
		status = simulation.f->hash(&simulation, &hash);
	if (status == SCREE_OK)
		print_row(figure, curve, &simulation, records, count, hash);
	simulation_close(&simulation);
	scene_free(scene);
	return report(status);
}

// The curve on the CPU and the one on OpenCL of both pipelines; of a device that is not there none.
static int curves_of(const Options* options, Curve curves[MAX_CURVES])
{
	scree_device devices[16];
	int found = 0, far = 0;
	if (scree_get_devices(devices, 16, &found) == SCREE_OK)
		for (int k = 0; k < found && k < 16; ++k)
			far += strncmp(devices[k].name, "opencl", 6) == 0;
	if (far == 0)
		fprintf(stderr, "scree bench: no curves of OpenCL: %s\n", scree_opencl_remedy());
	bool named = options->device && strncmp(options->device, "opencl", 6) == 0;
	const char* device = named ? options->device : "opencl";
	int count = 0;
	for (int p = 0; p < 2; ++p)
		for (int d = 0; d < 1 + (far > 0); ++d)
			curves[count++] = (Curve){.pipeline = p ? PIPELINE_SOFT : PIPELINE_PAPER,
			                          .name = p ? "scree" : "paper",
			                          .device = d ? device : "cpu"};
	return count;
}

// Where OpenCL becomes faster than the CPU, between two sizes: both costs are taken for powers of the number of bodies.
static void cross(Figure* figure, const Curve* near, const Curve* far, const Curve* near_before,
                  const Curve* far_before)
{
	double now = log(near->ms / far->ms), before = log(near_before->ms / far_before->ms);
	if (near->ended || near_before->ms == 0 || before >= 0 || now < 0)
		return;
	double share = before / (before - now);
	double bodies = exp(log(near_before->bodies) + share * log(near->bodies / near_before->bodies));
	double ms = exp(log(near_before->ms) + share * log(near->ms / near_before->ms));
	plot_mark(&figure->plot, bodies, ms, near->name);
	printf("%s: OpenCL is faster than the CPU from %.0f bodies on\n", near->name, bodies);
}

static int measure_all(Figure* figure, const int* sizes, int size_count)
{
	Curve curves[MAX_CURVES], before[MAX_CURVES] = {0};
	int count = curves_of(figure->options, curves), code = EXIT_GOOD;
	for (int k = 0; k < size_count && code == EXIT_GOOD; ++k)
	{
		for (int c = 0; c < count && code == EXIT_GOOD; ++c)
			if (!curves[c].ended)
				code = measure(figure, &curves[c], sizes[k]);
		for (int c = 0; c + 1 < count && code == EXIT_GOOD; c += 2)
			if (count == MAX_CURVES)
				cross(figure, &curves[c], &curves[c + 1], &before[c], &before[c + 1]);
		memcpy(before, curves, sizeof before);

		// the paper tests every pair: what the next size takes can be told from this one
		for (int c = 0; c < count && k + 1 < size_count; ++c)
		{
			double growth = (double)sizes[k + 1] / sizes[k];
			double next = curves[c].ms * (curves[c].pipeline == PIPELINE_PAPER ? growth * growth : growth);
			curves[c].ended = curves[c].ended || next > (figure->timings ? LONG_LIMIT : STEP_LIMIT);
		}
	}
	return code;
}

int figure_command(const Options* options, int number)
{
	static const int over[] = {20,   50,   100,  150,   200,   250,   300,    350,    400,    450,    500,
	                           1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000};
	static const int at[] = {100, 10000, 1000000};
	char csv[32], name[16];
	snprintf(name, sizeof name, "figure%d", number);
	snprintf(csv, sizeof csv, "%s.csv", name);
	if (options->setting_count + 3 > MAX_SETTINGS)
	{
		fprintf(stderr, "scree bench: %s chooses its scenes itself: leave out --set\n", name);
		return EXIT_BAD;
	}
	Figure figure = {.options = options, .timings = number == 6, .csv = fopen(csv, "w")};
	if (!figure.csv)
	{
		fprintf(stderr, "scree bench: cannot write %s: %s\n", csv, strerror(errno));
		return EXIT_FAILED;
	}
	fputs("pipeline,device,bodies,steps,contacts,ms_step", figure.csv);
	for (int k = 0; k < STAGES && figure.timings; ++k)
		fprintf(figure.csv, ",%s", stages[k]);
	fputs(",penetration,hash\n", figure.csv);
	int code = number == 5 ? measure_all(&figure, over, (int)(sizeof over / sizeof *over))
	                       : measure_all(&figure, at, (int)(sizeof at / sizeof *at));
	if (fclose(figure.csv) != 0 && code == EXIT_GOOD)
	{
		fprintf(stderr, "scree bench: cannot write %s: %s\n", csv, strerror(errno));
		code = EXIT_FAILED;
	}
	return code == EXIT_GOOD ? plot_figure(&figure.plot, name) : code;
}
