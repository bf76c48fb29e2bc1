// SPDX-License-Identifier: MIT
// churn.c -- bodies that jump across the world or are created anew in every step cost little, and a burst's memory returns.
//
// Times are of this machine at this moment; what must hold is their ratio to the same world without churn.
#include "props.h"
#include <math.h>
#include <stdlib.h>
#include <time.h>

#define WARM_UP 3 // steps whose time does not count

typedef enum
{
	NOTHING,
	TELEPORTED,
	REPLACED
} Churn;

static double seconds(void)
{
	struct timespec now;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int rising(const void* a, const void* b)
{
	double x = *(const double*)a, y = *(const double*)b;
	return (x > y) - (x < y);
}

// Circles that drift in a square where each has 2 m, of which some jump to random places in every step.
static double median_step(Validation* v, int count, Churn churn, int moved, int steps)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	Lab* lab = lab_open(v, &def);
	scree_attribute_def circle = circle_of(0.4);
	int side = (int)ceil(sqrt(count));
	uint64_t seed = 17;
	for (int k = 0; k < count; ++k)
		lab_throw(
		    lab, &circle, 2.0f * (float)(k % side), 2.0f * (float)(k / side), 0.0f,
		    (scree_velocity){{(float)random_between(&seed, -1.0, 1.0), (float)random_between(&seed, -1.0, 1.0)}, 0.0f});
	int* bodies = malloc((size_t)moved * sizeof *bodies);
	scree_pose* poses = malloc((size_t)moved * sizeof *poses);
	double* times = malloc((size_t)steps * sizeof *times);
	int next = 0;
	for (int step = 0; step < WARM_UP + steps && bodies && poses && times; ++step)
	{
		for (int k = 0; k < moved; ++k, next = (next + 7919) % count)
		{
			bodies[k] = next;
			poses[k] = (scree_pose){
			    {(float)random_between(&seed, 0.0, 2.0 * side), (float)random_between(&seed, 0.0, 2.0 * side)},
			    {1.0f, 0.0f}};
		}
		double begin = seconds();
		if (churn == TELEPORTED)
			lab_teleport(lab, bodies, poses, moved);
		if (churn == REPLACED)
			lab_replace(lab, bodies, poses, moved);
		lab_step(lab, 1);
		lab_wait(lab);
		if (step >= WARM_UP)
			times[step - WARM_UP] = seconds() - begin;
	}
	double median = 0.0;
	if (times)
	{
		qsort(times, (size_t)steps, sizeof *times, rising);
		median = times[steps / 2];
	}
	free(bodies);
	free(poses);
	free(times);
	lab_close(lab);
	return 1e3 * median;
}

static void crowd_moves(Validation* v, int count, int teleported, int replaced, int steps)
{
	begin(v, "%d circles", count);
	double calm = median_step(v, count, NOTHING, 1, steps);
	row(v, "median step", calm, "ms", SHOWN, 0.0);
	begin(v, "%d circles of which %d are teleported in each step", count, teleported);
	double busy = median_step(v, count, TELEPORTED, teleported, steps);
	row(v, "median step", busy, "ms", SHOWN, 0.0);
	row(v, "time over that without", busy / calm, "", AT_MOST, 3.0);
	begin(v, "%d circles of which %d are created anew in each step", count, replaced);
	busy = median_step(v, count, REPLACED, replaced, steps);
	row(v, "median step", busy, "ms", SHOWN, 0.0);
	row(v, "time over that without", busy / calm, "", AT_MOST, 3.0);
}

// All bodies spread out, then at one place for some steps, then spread out again: the memory returns.
static void burst(Validation* v, int count)
{
	begin(v, "%d boxes at one place for three steps", count);
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	Lab* lab = lab_open(v, &def);
	scree_attribute_def box = box_of(0.5, 0.5);
	int* bodies = malloc((size_t)count * sizeof *bodies);
	scree_pose* spread = malloc((size_t)count * sizeof *spread);
	scree_pose* heaped = malloc((size_t)count * sizeof *heaped);
	int side = (int)ceil(sqrt(count));
	for (int k = 0; k < count && bodies && spread && heaped; ++k)
	{
		bodies[k] = lab_put(lab, SCREE_DYNAMIC, &box, 2.0f * (float)(k % side), 2.0f * (float)(k / side), 0.0f);
		spread[k] = (scree_pose){{2.0f * (float)(k % side), 2.0f * (float)(k / side)}, {1.0f, 0.0f}};
		heaped[k] = (scree_pose){{0.001f * (float)(k % side), 0.001f * (float)(k / side)}, {1.0f, 0.0f}};
	}
	lab_step(lab, 10);
	double before = lab_bytes(lab), most = 0.0;
	lab_teleport(lab, bodies, heaped, count);
	for (int step = 0; step < 3; ++step)
	{
		lab_step(lab, 1);
		most = fmax(most, lab_bytes(lab));
	}
	lab_teleport(lab, bodies, spread, count);
	for (int k = 0; k < count; ++k)
		lab_set_velocity(lab, bodies[k], (scree_velocity){{0.0f, 0.0f}, 0.0f});
	lab_step(lab, 300);
	row(v, "most memory", 1e-6 * most, "MB", SHOWN, 0.0);
	row(v, "memory after it over that before", lab_bytes(lab) / before, "", AT_MOST, 3.0);
	free(bodies);
	free(spread);
	free(heaped);
	lab_close(lab);
}

void churn_experiment(Validation* v)
{
	if (v->quick)
	{
		crowd_moves(v, 5000, 100, 400, 20);
		burst(v, 300);
		return;
	}
	crowd_moves(v, 50000, 1000, 4000, 20);
	burst(v, 2000);
}
