// SPDX-License-Identifier: MIT
// overlaps.c -- measures the depth of overlaps and the sinking of stacks in the six scenes of the benchmarks.
//
// The limit of a mean is at most 0.8 of Box2D's mean (617d32a, sleep off), which is in mm: pyramid 21.3, pyramids 1.93,
// pile 109, tumbler 89.0, smash 86.6, washer 59.7, 7 piles 119, 7 drums 86.8. In scenes whose bodies hardly move, the
// limit is the result of this version plus 1/20. The limit of the deepest overlap in smash is Box2D's result, because
// Box2D does better there than in other scenes.
#include "lab_scene.h"
#include "validate.h"
#include <math.h>
#include <stdio.h>

#define RUNS 7

typedef struct
{
	const char* name;
	int every; // steps between two measurements; a measurement takes as long as several steps
	// mm: limit of the largest overlap (0: no limit); limit of the mean of the deepest overlaps at each measurement
	double deepest, mean;
	double sank; // limit, mm: sinking of the body that sank the most; 0: the scene has no stack
} Known;

static const Known scenes[] = {
    {"pyramid", 4, 19.0, 12.7, 388.0}, {"pyramids", 10, 1.05, 0.77, 3.27}, {"pile", 1, 0.0, 86.9, 0.0},
    {"tumbler", 1, 160.0, 71.2, 0.0},  {"smash", 1, 191.0, 69.3, 0.0},     {"washer", 1, 145.0, 47.7, 0.0},
};

typedef struct // m: results of a run: largest overlap; mean of the deepest overlaps at each measurement
{
	double deepest, mean;
	int step; // number of the step with the largest overlap
} Depths;

static Depths depths_of(Lab* lab, int steps, int every)
{
	Depths depths = {0};
	for (int step = every; step <= steps; step += every)
	{
		lab_step(lab, every);
		double overlap = lab_overlap(lab, NULL);
		if (overlap > depths.deepest)
			depths.step = step;
		depths.deepest = larger(depths.deepest, overlap);
		depths.mean += overlap * every / steps;
	}
	return depths;
}

static void watch(Validation* v, const Known* known, int steps)
{
	begin(v, "%s", known->name);
	Lab* lab = lab_scene(v, known->name, NULL);
	Depths depths = depths_of(lab, steps, known->every);
	double sank = 0.0;
	for (int k = 0; k < lab->count; ++k)
		sank = larger(sank, (double)(lab->bodies[k].def.pose.position.y - lab->poses[k].position.y));
	bool judged = !v->quick;
	where(v, "step %d", depths.step);
	row(v, "deepest overlap", 1e3 * depths.deepest, "mm", judged && known->deepest > 0.0 ? AT_MOST : SHOWN,
	    known->deepest);
	row(v, "mean of the deepest at each look", 1e3 * depths.mean, "mm", judged ? AT_MOST : SHOWN, known->mean);
	if (known->sank > 0.0)
		row(v, "sank", 1e3 * sank, "mm", judged ? AT_MOST : SHOWN, known->sank);
	row(v, "bodies frozen", lab->frozen, "", AT_MOST, 0.0);
	lab_close(lab);
}

// A scene that runs several times, each with another value of a parameter. The result of a single run is random: one
// body more or less changes the deepest overlap of a pile from 0.14 to 0.26 m, and the mean of a drum from 50 to 65 mm.
typedef struct
{
	const char *name, *scene, *parameter;
	int first, apart;     // value of the parameter in the first run, and its increase from run to run
	int steps;            // steps of a run
	double deepest, mean; // mm: limits of the medians of Depths.deepest and Depths.mean over all runs
} Several;

static const Several repeated[] = {
    {"7 piles", "pile", "count", 1970, 10, 200, 210.0, 94.9},
    {"7 drums", "tumbler", "degrees", 22, 1, 600, 134.0, 69.4},
};

static void watch_several(Validation* v, const Several* known)
{
	double deepest[RUNS] = {0.0}, mean[RUNS] = {0.0};
	begin(v, "%s", known->name);
	for (int run = 0; run < RUNS; ++run)
	{
		char value[16];
		snprintf(value, sizeof value, "%d", known->first + run * known->apart);
		SceneSetting setting = {.name = known->parameter, .value = value};
		Lab* lab = lab_scene(v, known->scene, &setting);
		Depths depths = depths_of(lab, known->steps, 1);
		deepest[run] = depths.deepest;
		mean[run] = depths.mean;
		lab_close(lab);
	}
	v->steps = known->steps;
	row(v, "median of the deepest overlaps", 1e3 * upper_median_of(deepest, RUNS), "mm", AT_MOST, known->deepest);
	row(v, "median of the means", 1e3 * upper_median_of(mean, RUNS), "mm", AT_MOST, known->mean);
}

void overlaps_experiment(Validation* v)
{
	for (int k = 0; k < 6; ++k)
	{
		if (!v->quick || k == 2)
			watch(v, &scenes[k], v->quick ? 60 : 600);
	}
	for (int k = 0; !v->quick && k < 2; ++k)
		watch_several(v, &repeated[k]);
}
