// SPDX-License-Identifier: MIT
// churn.c -- bodies that jump across the world or are replaced in every step cost little time, and memory for many
// contacts is released.
//
// Times depend on the machine, so the limits apply to ratios: the time of a step divided by that of the same world
// without churn.
#include "props.h"
#include "tools/common/clock.h"
#include <math.h>
#include <stdlib.h>

#define WARM_UP 3 // steps that are not timed

typedef enum
{
	NOTHING,
	TELEPORTED,
	REPLACED
} Churn;

typedef struct // ms: medians of the time of a step
{
	double churned, after; // steps with churn; later steps without churn
} Medians;

// Measures a world of circles that drift in a square with 2 m x 2 m for each circle. In the first steps, `moved`
// circles jump to random places or are replaced. The same number of steps follows without churn, because jumps leave
// circles close together, so that the world then has more contacts.
static Medians median_steps(Validation* v, int count, Churn churn, int moved, int steps)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	Lab* lab = lab_open(v, &def);
	scree_attribute_def circle = circle_of(0.4);
	int side = (int)ceil(sqrt(count));
	uint64_t seed = 17;
	for (int k = 0; k < count; ++k)
		lab_throw(lab, &circle, 2.0f * (float)(k % side), 2.0f * (float)(k / side), 0.0f,
		          (scree_velocity){{(float)random_real(&seed, -1.0, 1.0), (float)random_real(&seed, -1.0, 1.0)}, 0.0f});
	int* bodies = require_memory(malloc((size_t)moved * sizeof *bodies));
	scree_pose* poses = require_memory(malloc((size_t)moved * sizeof *poses));
	double* times = require_memory(malloc(2 * (size_t)steps * sizeof *times));
	int next = 0;
	for (int step = 0; step < WARM_UP + 2 * steps; ++step)
	{
		bool jumps = step < WARM_UP + steps;
		for (int k = 0; k < moved; ++k, next = (next + 7919) % count)
		{
			bodies[k] = next;
			poses[k] = (scree_pose){
			    {(float)random_real(&seed, 0.0, 2.0 * side), (float)random_real(&seed, 0.0, 2.0 * side)}, {1.0f, 0.0f}};
		}
		double begin = seconds_now();
		if (jumps && churn == TELEPORTED)
			lab_teleport(lab, bodies, poses, moved);
		if (jumps && churn == REPLACED)
			lab_replace(lab, bodies, poses, moved);
		lab_step(lab, 1);
		lab_wait(lab);
		if (step >= WARM_UP)
			times[step - WARM_UP] = seconds_now() - begin;
	}
	Medians medians = {1e3 * upper_median_of(times, steps), 1e3 * upper_median_of(times + steps, steps)};
	free(bodies);
	free(poses);
	free(times);
	lab_close(lab);
	return medians;
}

static void crowd_moves(Validation* v, int count, int teleported, int replaced, int steps)
{
	begin(v, "%d circles", count);
	double calm = median_steps(v, count, NOTHING, 1, steps).churned;
	row(v, "median step", calm, "ms", SHOWN, 0.0);
	begin(v, "%d circles of which %d are teleported in each step", count, teleported);
	Medians busy = median_steps(v, count, TELEPORTED, teleported, steps);
	row(v, "median step", busy.churned, "ms", SHOWN, 0.0);
	row(v, "time over that without", busy.churned / calm, "", AT_MOST, 3.0);
	row(v, "time over that of the same circles once they are left alone", busy.churned / busy.after, "", SHOWN, 0.0);
	begin(v, "%d circles of which %d are created anew in each step", count, replaced);
	busy = median_steps(v, count, REPLACED, replaced, steps);
	row(v, "median step", busy.churned, "ms", SHOWN, 0.0);
	row(v, "time over that without", busy.churned / calm, "", AT_MOST, 3.0);
	row(v, "time over that of the same circles once they are left alone", busy.churned / busy.after, "", SHOWN, 0.0);
}

typedef struct
{
	Lab* lab;
	int count, *bodies;
	scree_pose *spread, *heaped;
} Crowd;

// Creates boxes without gravity, and two lists of their poses: spread out, and all at one place.
static Crowd gather(Validation* v, int count)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	Crowd c = {.lab = lab_open(v, &def), .count = count};
	scree_attribute_def box = box_of(0.5, 0.5);
	size_t room = (size_t)count;
	c.bodies = require_memory(malloc(room * sizeof *c.bodies));
	c.spread = require_memory(malloc(room * sizeof *c.spread));
	c.heaped = require_memory(malloc(room * sizeof *c.heaped));
	int side = (int)ceil(sqrt(count));
	for (int k = 0; k < count; ++k)
	{
		float x = 2.0f * (float)(k % side), y = 2.0f * (float)(k / side);
		c.bodies[k] = lab_put(c.lab, SCREE_BODY_DYNAMIC, &box, x, y, 0.0f);
		c.spread[k] = (scree_pose){{x, y}, {1.0f, 0.0f}};
		c.heaped[k] = (scree_pose){{0.0005f * x, 0.0005f * y}, {1.0f, 0.0f}};
	}
	return c;
}

static void disperse(Crowd* c)
{
	lab_teleport(c->lab, c->bodies, c->spread, c->count);
	for (int k = 0; k < c->count; ++k)
		lab_set_velocity(c->lab, c->bodies[k], (scree_velocity){{0.0f, 0.0f}, 0.0f});
}

static void dismiss(Crowd* c)
{
	free(c->bodies);
	free(c->spread);
	free(c->heaped);
	lab_close(c->lab);
}

// Moves all boxes to one place for three steps, then spreads them again. The memory of their contacts must then be
// released.
static void burst(Validation* v, int count)
{
	begin(v, "%d boxes at one place for three steps", count);
	Crowd c = gather(v, count);
	lab_step(c.lab, 10);
	double before = lab_bytes(c.lab), most = 0.0;
	lab_teleport(c.lab, c.bodies, c.heaped, count);
	for (int step = 0; step < 3; ++step)
	{
		lab_step(c.lab, 1);
		most = larger(most, lab_bytes(c.lab));
	}
	disperse(&c);
	lab_step(c.lab, 300);
	row(v, "most memory", 1e-6 * most, "MB", SHOWN, 0.0);
	row(v, "memory after it over that before", lab_bytes(c.lab) / before, "", AT_MOST, 3.0);
	dismiss(&c);
}

// Moves too many boxes to one place. The step may fail with a message, but the memory must stay below 1 GB, and the
// next steps must succeed. Returns whether the step failed.
static bool crowd(Validation* v, int count)
{
	begin(v, "%d boxes at one place", count);
	Crowd c = gather(v, count);
	lab_step(c.lab, 10);
	lab_teleport(c.lab, c.bodies, c.heaped, count);
	bool taken = lab_try(c.lab);
	where(v, "the step was %s", taken ? "taken" : "refused");
	row(v, "memory", 1e-6 * lab_bytes(c.lab), "MB", AT_MOST, 1000.0);
	disperse(&c);
	row(v, "steps that it goes on", lab_try(c.lab) + lab_try(c.lab), "", AT_LEAST, 2.0);
	dismiss(&c);
	return !taken;
}

void churn_experiment(Validation* v)
{
	if (v->quick)
	{
		crowd_moves(v, 20000, 400, 1600, 20);
		burst(v, 300);
		return;
	}
	crowd_moves(v, 50000, 1000, 4000, 20);
	burst(v, 1200);
	// the second call runs only if the step of the first was refused, because 22,000 boxes have 242 million pairs,
	// which need 24 GB or more
	if (crowd(v, 2500))
		crowd(v, 22000);
}
