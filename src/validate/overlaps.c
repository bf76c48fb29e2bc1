// SPDX-License-Identifier: MIT
// overlaps.c -- the six scenes of the benchmarks: how deep bodies overlap, and how far stacks sink.
//
// Limits are what f723e87 did and some more, so that what was good stays: a twentieth where bodies hardly move, and as much
// as the order of creation alone changed elsewhere, a seventh of the deepest overlap. The one of smash is what Box2D v3
// (617d32a, sleep off) does, which was better there.
#include "lab_scene.h"
#include "validate.h"
#include <math.h>
#include <stdio.h>

#define PILES 7

typedef struct
{
	const char* name;
	int every;            // steps from one look to the next; each costs as much as some steps
	double deepest, mean; // mm, at most: of all looks, or 0, and mean of the deepest of each
	double sank;          // mm, at most, the body that sank most; 0: not a stack
} Known;

static const Known scenes[] = {
    {"pyramid", 4, 18.4, 8.63, 300.0}, {"pyramids", 10, 1.05, 0.77, 3.27}, {"pile", 1, 0.0, 46.0, 0.0},
    {"tumbler", 1, 160.0, 64.0, 0.0},  {"smash", 1, 191.0, 52.0, 0.0},     {"washer", 1, 145.0, 35.0, 0.0},
};

static void watch(Validation* v, const Known* known, int steps)
{
	int every = known->every;
	begin(v, "%s", known->name);
	Lab* lab = lab_scene(v, known->name, NULL);
	double deepest = 0.0, sum = 0.0, sank = 0.0;
	int deepest_step = 0;
	for (int step = every; step <= steps; step += every)
	{
		lab_step(lab, every);
		double overlap = lab_overlap(lab, NULL);
		if (overlap > deepest)
			deepest_step = step;
		deepest = fmax(deepest, overlap);
		sum += overlap * every / steps;
	}
	for (int k = 0; k < lab->count; ++k)
		sank = fmax(sank, (double)(lab->bodies[k].def.pose.position.y - lab->poses[k].position.y));
	bool judged = !v->quick;
	where(v, "step %d", deepest_step);
	row(v, "deepest overlap", 1e3 * deepest, "mm", judged && known->deepest > 0.0 ? AT_MOST : SHOWN, known->deepest);
	row(v, "mean of the deepest at each look", 1e3 * sum, "mm", judged ? AT_MOST : SHOWN, known->mean);
	if (known->sank > 0.0)
		row(v, "sank", 1e3 * sank, "mm", judged ? AT_MOST : SHOWN, known->sank);
	row(v, "bodies frozen", lab->frozen, "", AT_MOST, 0.0);
	lab_close(lab);
}

// The deepest overlap of one pile is chance: a body more or less makes of 0.14 m 0.26.
static void piles(Validation* v, int steps)
{
	double deepest[PILES] = {0.0};
	begin(v, "%d piles", PILES);
	for (int run = 0; run < PILES; ++run)
	{
		char bodies[16];
		snprintf(bodies, sizeof bodies, "%d", 1970 + 10 * run);
		SceneSetting setting = {.name = "count", .value = bodies};
		Lab* lab = lab_scene(v, "pile", &setting);
		for (int step = 0; step < steps; ++step)
		{
			lab_step(lab, 1);
			deepest[run] = fmax(deepest[run], lab_overlap(lab, NULL));
		}
		lab_close(lab);
	}
	v->steps = steps;
	row(v, "median of the deepest overlaps", 1e3 * middle(deepest, PILES), "mm", AT_MOST, 210.0);
}

void overlaps_experiment(Validation* v)
{
	for (int k = 0; k < 6; ++k)
	{
		if (!v->quick || k == 2)
			watch(v, &scenes[k], v->quick ? 60 : 600);
	}
	if (!v->quick)
		piles(v, 200);
}
