// SPDX-License-Identifier: MIT
// stiffness.c -- scree_peers stiffness: measures how far joints give way in both engines.
//
// Each row is a scene at 60 Hz with 4 substeps. After every step one quantity is computed from the poses. The table has
// its largest value, its mean and its last value, for the steps after the time Row.from. Before that time, the bodies
// move from their unloaded start.
#include "stiffness.h"
#include "engine_box2d.h"
#include "measure.h"
#include "mirror.h"
#include "process.h"
#include "validate/engine_scree.h"
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#define SETTINGS 4

static const char* const help = "usage: scree_peers stiffness [OPTION]... [NAME]...\n"
                                "\n"
                                "Measures how far joints give way in both engines, 60 Hz with 4 substeps; CSV on "
                                "standard output. Without a name: all "
                                "rows.\n"
                                "\n"
                                "  -d, --device NAME   where Scree runs, cpu without it\n"
                                "  -h, --help          this text\n";

static const struct option words_known[] = {
    {"device", required_argument, NULL, 'd'}, {"help", no_argument, NULL, 'h'}, {0}};

typedef enum
{
	STRETCH,    // sum of the gaps of all joints, % of the original length
	SAG,        // largest descent of a body since the start, m
	SEPARATION, // widest gap of a joint, m
	RESTLESS,   // mean of the squared speeds of all bodies, m^2/s^2
	QUANTITIES
} Quantity;

static const char* const quantities[QUANTITIES] = {
    [STRETCH] = "stretch (%)",
    [SAG] = "sag (m)",
    [SEPARATION] = "separation (m)",
    [RESTLESS] = "mean square speed (m2/s2)",
};

typedef struct
{
	const char *name, *fixture;
	SceneSetting settings[SETTINGS]; // the list ends at a null name
	Quantity quantity;
	float length;      // m: original length, for STRETCH
	float from, until; // s: begin and end of the time in which steps are measured
} Row;

#define ROPE(load, level) "ropes", {{"count", "1"}, {"load", load}, {"level", level}}, STRETCH, 20.0f, 1.0f, 20.0f

static const Row rows[] = {
    {"rope 1:1 hanging", ROPE("1", "0")},
    {"rope 10:1 hanging", ROPE("10", "0")},
    {"rope 100:1 hanging", ROPE("100", "0")},
    {"rope 1000:1 hanging", ROPE("1000", "0")},
    {"rope 1:1 swinging", ROPE("1", "1")},
    {"rope 10:1 swinging", ROPE("10", "1")},
    {"rope 100:1 swinging", ROPE("100", "1")},
    {"rope 1000:1 swinging", ROPE("1000", "1")},
    {"bridge", "bridges", {{"count", "1"}, {"loads", "1"}, {"mass", "100"}}, STRETCH, 100.0f, 1.0f, 30.0f},
    {"bridge", "bridges", {{"count", "1"}, {"loads", "1"}, {"mass", "100"}}, SAG, 0.0f, 1.0f, 30.0f},
    {"beam", "beam", {{0}}, SAG, 0.0f, 1.0f, 30.0f},
    {"beam", "beam", {{0}}, SEPARATION, 0.0f, 1.0f, 30.0f},
    {"ragdolls", "humans", {{0}}, RESTLESS, 0.0f, 60.0f, 62.0f},
    {"ragdolls", "humans", {{0}}, SEPARATION, 0.0f, 60.0f, 62.0f},
    {"car", "car", {{0}}, SEPARATION, 0.0f, 1.0f, 15.0f},
    {"joint grid", "joint_grid", {{"size", "30"}}, SEPARATION, 0.0f, 1.0f, 10.0f},
};

typedef struct
{
	double most, mean, last;
} Values;

static double speeds(const Measure* measure, const scree_pose* before, float dt)
{
	double sum = 0.0;
	for (int k = 0; k < measure->count; ++k)
	{
		double x = (double)(measure->poses[k].position.x - before[k].position.x) / (double)dt,
		       y = (double)(measure->poses[k].position.y - before[k].position.y) / (double)dt;
		sum += x * x + y * y;
	}
	return sum / measure->count;
}

static double value_of(const Row* row, const Measure* measure, const scree_pose* before, float dt)
{
	switch (row->quantity)
	{
	case STRETCH:
		return 100.0 * measure->gaps / (double)row->length;
	case SAG:
		return (double)measure->sunk;
	case SEPARATION:
		return (double)measure->separation;
	default:
		return speeds(measure, before, dt);
	}
}

static bool take_steps(const Row* row, Mirror* mirror, Measure* measure, scree_pose* before, Values* values)
{
	int counted = 0;
	float dt = mirror->setup->dt;
	bool good = mirror_poses(mirror, measure->poses) && measure_take(measure);
	for (int k = 0; (float)k * dt < row->until && good; ++k)
	{
		memcpy(before, measure->poses, (size_t)measure->count * sizeof *before);
		measure->separation = 0.0f;
		measure->gaps = measure->gauged = 0.0;
		good = mirror_step(mirror) && mirror_poses(mirror, measure->poses) && measure_take(measure);
		if ((float)k * dt < row->from)
			continue;
		values->last = value_of(row, measure, before, dt);
		values->most = values->last > values->most ? values->last : values->most;
		values->mean += values->last;
		++counted;
	}
	values->mean /= counted;
	return good;
}

static bool run_row(const Row* row, const Engine* engine, const EngineOptions* options, const char* executable,
                    Values* values)
{
	Setup setup;
	Mirror mirror;
	Measure measure = {0};
	int count = 0;
	while (count < SETTINGS && row->settings[count].name)
		++count;
	if (!setup_load(&setup, row->fixture, executable, row->settings, count))
		return false;
	*values = (Values){0};
	bool good = mirror_open(&mirror, &setup, engine, options) && measure_open(&measure, &setup);
	scree_pose* before = good ? malloc((size_t)measure.count * sizeof *before) : NULL;
	good = before && take_steps(row, &mirror, &measure, before, values);
	free(before);
	measure_close(&measure);
	mirror_close(&mirror);
	setup_free(&setup);
	return good;
}

static bool chosen(const Row* row, char** names, int count)
{
	for (int k = 0; k < count; ++k)
	{
		if (strcmp(names[k], row->name) == 0)
			return true;
	}
	return count == 0;
}

int stiffness_peers(int count, char** words, const char* executable)
{
	EngineOptions options = {.threads = 1, .device = "cpu", .continuous = true};
	for (int letter; (letter = getopt_long(count, words, "d:h", words_known, NULL)) != -1;)
	{
		if (letter == 'h')
			printf("%s", help);
		if (letter != 'd')
			return letter == 'h' ? EXIT_GOOD : EXIT_BAD;
		options.device = optarg;
	}
	printf("trial,quantity,most_scree,most_box2d,mean_scree,mean_box2d,last_scree,last_box2d\n");
	for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k)
	{
		Values a, b;
		if (!chosen(&rows[k], words + optind, count - optind))
			continue;
		if (!run_row(&rows[k], &scree_engine, &options, executable, &a) ||
		    !run_row(&rows[k], &box2d_engine, &options, executable, &b))
			return EXIT_FAILED;
		printf("%s,%s,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g\n", rows[k].name, quantities[rows[k].quantity], a.most, b.most,
		       a.mean, b.mean, a.last, b.last);
		fflush(stdout);
	}
	return EXIT_GOOD;
}
