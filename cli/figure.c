// SPDX-License-Identifier: MIT
// figure.c -- scree bench figure5 and figure6: what the paper's two figures of measurements show, measured again.
//
// Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines. Figure 5: processing time over the number
// of bodies, on the CPU and on OpenCL. Figure 6: share of each stage in the time at 100 bodies. Here the paper's pipeline
// stands beside ours, and both go on to a million bodies; where a step would take too long, the row says how long.
//
// The paper does not say what its scene was, but that detection took most of the time "under normal conditions", and that many
// contacts, as of stacked bodies, move the bottleneck to resolution. So there are two scenes: boxes that drift, with
// few contacts, and pyramids of ten boxes.
//
// Both devices take equally many steps of a pipeline and size, and must leave the same hash.
#include "figure.h"
#include "commands.h"
#include "csv.h"
#include "record.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STEPS      40     // whose time counts, in a run that is not cut short
#define WARM_UP    4      // steps before them: kernels are built, buffers grow, boxes come to touch
#define FEWEST     3      // counting steps
#define TIME_LIMIT 0.5    // s, after which a run ends with fewer steps
#define LONG_LIMIT 3.0    // s: a run that takes longer is not repeated
#define FIGURE5_MS 1000.0 // a step may be expected to take, ms; else it is not run
#define FIGURE6_MS 30000.0

const char* const figure_scenes[FIGURE_SCENES] = {"drift", "pyramids"};
const char* const figure_pipelines[FIGURE_PIPELINES] = {"paper", "scree"};

#define STAGE_NAME(name) #name,
const char* const figure_stages[FIGURE_STAGE_COUNT] = {FIGURE_STAGES(STAGE_NAME)};

typedef struct // a pipeline on a device
{
	PipelineChoice pipeline;
	const char *name, *device; // as in the CSV; as for --device
	char label[160];           // of the device, in the CSV
	double bodies, ms;         // of its last row
	bool ended;                // larger sizes would take too long
} Curve;

typedef struct // what both devices share at one size
{
	int steps; // of a run; 0 until the first has ended
	int repeats;
	uint64_t hash;
	const char* device; // that left it
} Plan;

typedef struct
{
	const Options* options;
	FILE* csv;
	int number; // 5 or 6
	int scene;
	char settings[64]; // of the scene, as in the CSV
} Figure;

typedef struct
{
	Record* records; // of counting steps, repeat after repeat
	int count;
	double least, most; // median step of the fastest and of the slowest repeat, ms
	float penetration;  // of all steps, m
	int threads;
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

static void print_row(Figure* figure, Curve* curve, const Simulation* simulation, const Plan* plan, const Rows* rows)
{
	const scree_counters* last = &rows->records[rows->count - 1].counters;
	snprintf(curve->label, sizeof curve->label, "%s", scree_world_device(simulation->world));
	csv_cell(curve->label);
	curve->ms = median(rows->records, rows->count, step_of, 0);
	curve->bodies = last->bodies;
	fprintf(figure->csv, "%s,%s,%s,%s,%d,%d,%.0f,%d,%d,%.4f,%.4f,%.4f", figure_scenes[figure->scene], figure->settings,
	        curve->name, curve->label, rows->threads, last->bodies, median(rows->records, rows->count, touching_of, 0),
	        plan->steps, plan->repeats, curve->ms, rows->least, rows->most);
	for (int s = 0; s < FIGURE_STAGE_COUNT && figure->number == 6; ++s)
	{
		int k = 0;
		while (k < STAGE_COLUMNS && strcmp(simulation->f->stages[k], figure_stages[s]) != 0)
			++k;
		fprintf(figure->csv, ",%.4f", k < STAGE_COLUMNS ? median(rows->records, rows->count, stage_of, k) : 0.0);
	}
	fprintf(figure->csv, ",%.5f,%016" PRIx64 "\n", (double)rows->penetration, plan->hash);
	fflush(figure->csv);
	fprintf(stderr, "%s, %s on %s, %d bodies: %.3f ms a step\n", figure_scenes[figure->scene], curve->name,
	        curve->label, last->bodies, curve->ms);
}

// A row of no steps: what a step would take, from the last size that was run. The paper tests every pair, and goes through
// all contacts after each resolution.
static void print_estimate(Figure* figure, const Curve* curve, int bodies, double ms)
{
	fprintf(figure->csv, "%s,%s,%s,%s,,%d,,0,0,%.0f,,", figure_scenes[figure->scene], figure->settings, curve->name,
	        curve->label, bodies, ms);
	for (int s = 0; s < FIGURE_STAGE_COUNT && figure->number == 6; ++s)
		fprintf(figure->csv, ",");
	fprintf(figure->csv, ",,\n");
}

static double estimate(const Curve* curve, int bodies)
{
	double growth = curve->bodies > 0 ? bodies / curve->bodies : 0;
	return curve->ms * (curve->pipeline == PIPELINE_PAPER ? growth * growth : growth);
}

// Takes the steps of the plan, or as many as fit into the limits, which makes the plan.
static scree_status take_steps(Simulation* simulation, const Options* options, Plan* plan, Rows* rows)
{
	int most = plan->steps > 0 ? plan->steps : WARM_UP + (options->steps > 0 ? options->steps : STEPS), step = 0;
	int before = rows->count;
	double begin = seconds_now();
	scree_status status = SCREE_OK;
	for (; step < most && status == SCREE_OK; ++step)
	{
		if (plan->steps == 0 && step >= WARM_UP + FEWEST && seconds_now() - begin > TIME_LIMIT)
			break;
		Record* record = &rows->records[rows->count++];
		status = record_step(simulation, record);
		rows->penetration = fmaxf(rows->penetration, record->counters.penetration);
	}
	rows->count -= step < WARM_UP ? step : WARM_UP;
	memmove(rows->records + before, rows->records + before + WARM_UP,
	        (size_t)(rows->count - before) * sizeof *rows->records);
	if (plan->steps == 0)
	{
		plan->steps = step;
		plan->repeats = seconds_now() - begin > LONG_LIMIT ? 1 : options->repeats;
	}
	double middle = median(rows->records + before, rows->count - before, step_of, 0);
	rows->least = before == 0 ? middle : fmin(rows->least, middle);
	rows->most = fmax(rows->most, middle);
	return status;
}

static int check_hash(const Figure* figure, const Curve* curve, const Simulation* simulation, Plan* plan, uint64_t hash)
{
	if (!plan->device)
	{
		plan->hash = hash;
		plan->device = curve->device;
	}
	if (plan->hash == hash)
		return EXIT_GOOD;
	fprintf(stderr,
	        "scree bench: %s, %s, %d steps: the hash is %016" PRIx64 " on %s, but was %016" PRIx64 " on %s before\n",
	        figure_scenes[figure->scene], curve->name, plan->steps, hash, scree_world_device(simulation->world),
	        plan->hash, plan->device);
	return EXIT_FAILED;
}

static int run_once(Figure* figure, Curve* curve, const Options* options, const Scene* scene, Plan* plan, Rows* rows,
                    int repeat)
{
	Simulation simulation;
	int code = simulation_open(options, scene, figure->number == 6, &simulation);
	if (code != EXIT_GOOD)
		return code;
	uint64_t hash = 0;
	scree_status status = take_steps(&simulation, options, plan, rows);
	if (status == SCREE_OK)
		status = simulation.f->hash(&simulation, &hash);
	code = report(status);
	if (code == EXIT_GOOD)
		code = check_hash(figure, curve, &simulation, plan, hash);
	rows->threads = simulation.f->one_thread ? 1 : scree_world_threads(simulation.world);
	if (code == EXIT_GOOD && repeat + 1 == plan->repeats)
		print_row(figure, curve, &simulation, plan, rows);
	simulation_close(&simulation);
	return code;
}

static int measure(Figure* figure, Curve* curve, Plan* plan, const Options* sized)
{
	Options options = *sized;
	options.pipeline = curve->pipeline;
	options.device = curve->device;
	Scene* scene = open_scene(&options, figure_scenes[figure->scene]);
	if (!scene)
		return EXIT_BAD;
	int steps = WARM_UP + (options.steps > 0 ? options.steps : STEPS), code = EXIT_GOOD;
	Rows all = {.records = malloc((size_t)steps * (size_t)options.repeats * sizeof(Record))};
	if (!all.records)
	{
		fprintf(stderr, "scree bench: out of memory for %d steps\n", steps);
		code = EXIT_FAILED;
	}
	for (int repeat = 0; code == EXIT_GOOD && repeat < (plan->steps > 0 ? plan->repeats : options.repeats); ++repeat)
		code = run_once(figure, curve, &options, scene, plan, &all, repeat);
	free(all.records);
	scene_free(scene);
	return code;
}

// The curve on the CPU and the one on OpenCL of both pipelines; of a device that is not there none. --device cpu leaves out the
// second.
static int curves_of(const Options* options, Curve curves[2 * FIGURE_PIPELINES])
{
	scree_device devices[16];
	int found = 0, far = 0;
	bool alone = options->device && strcmp(options->device, "cpu") == 0;
	if (!alone && scree_get_devices(devices, 16, &found) == SCREE_OK)
		for (int k = 0; k < found && k < 16; ++k)
			far += strncmp(devices[k].name, "opencl", 6) == 0;
	if (far == 0 && !alone)
		fprintf(stderr, "scree bench: no curves of OpenCL: %s\n", scree_opencl_remedy());
	bool named = options->device && strncmp(options->device, "opencl", 6) == 0;
	const char* device = named ? options->device : "opencl";
	int count = 0;
	for (int p = 0; p < FIGURE_PIPELINES; ++p)
		for (int d = 0; d < 1 + (far > 0); ++d)
			curves[count++] = (Curve){.pipeline = p ? PIPELINE_SOFT : PIPELINE_PAPER,
			                          .name = figure_pipelines[p],
			                          .device = d ? device : "cpu"};
	return count;
}

// All curves of one scene, size by size.
static int measure_scene(Figure* figure, const int* sizes, int size_count)
{
	Curve curves[2 * FIGURE_PIPELINES];
	int count = curves_of(figure->options, curves), code = EXIT_GOOD, before = 0;
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
				code = measure(figure, &curves[c], &plan, &sized);
		}
		before = size.bodies;
	}
	return code;
}

static int write_csv(const Options* options, const char* csv, int number)
{
	static const int over[] = {25,  50,  75,   100,  125,  150,   175,   200,   225,    240,    248,    256,    264,
	                           272, 280, 300,  325,  350,  375,   400,   425,   450,    475,    500,    512,    528,
	                           550, 700, 1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000};
	static const int at[] = {100, 10000, 1000000};
	const int* sizes = number == 5 ? over : at;
	int count = number == 5 ? (int)(sizeof over / sizeof *over) : (int)(sizeof at / sizeof *at), code = EXIT_GOOD;
	while (count > 1 && options->limit > 0 && sizes[count - 1] > options->limit)
		--count;
	Figure figure = {.options = options, .number = number, .csv = fopen(csv, "w")};
	if (!figure.csv)
	{
		fprintf(stderr, "scree bench: cannot write %s: %s\n", csv, strerror(errno));
		return EXIT_FAILED;
	}
	fputs("scene,settings,pipeline,device,threads,bodies,contacts,steps,repeats,ms_step,ms_least,ms_most", figure.csv);
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
