// SPDX-License-Identifier: MIT
// rest.c -- checks that bodies at rest stay in place: circles on a floor, capsules, rounded boxes, heaps of mixed
// bodies.
#include "props.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define ENERGY 1.0e-6 // J: limit of the mean kinetic energy of a body
#define SPEED  1.0    // mm/s: limit for the fastest body
#define CREEP  1.0    // mm per minute: limit of creep

#define SIZES  7
#define STARTS 8

// largest values of all bodies so far, and the body with the largest motion
typedef struct
{
	double moved, speed; // largest displacement, mm; largest speed, mm/s
	int start, body;
} Worst;

static const float sizes[SIZES] = {0.05f, 0.1f, 0.2f, 0.5f, 1.0f, 2.0f, 5.0f};
static const float starts[STARTS] = {0.0f, 0.1f, 0.37f, 1.23f, 10.1f, 100.3f, -33.7f, 1000.3f};

static scree_attribute_def shape_of(int kind, float size)
{
	return kind == 0   ? circle_of((double)size)
	       : kind == 1 ? capsule_of((double)size, (double)size)
	       : kind == 2 ? rounded_of((double)size, (double)size, 0.2 * (double)size)
	                   : box_of((double)size, (double)size);
}

// Puts seven bodies of one kind and different sizes side by side on a floor. start: index in `starts` of the
// position of the first body. Updates *worst with the motions of the bodies.
static void lie(Validation* v, int kind, int start, int steps, Worst* worst)
{
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	int first = add_floor(lab, 1200.0) + 1;
	for (int k = 0; k < SIZES; ++k)
	{
		scree_attribute_def surface = shape_of(kind, sizes[k]);
		lab_put(lab, SCREE_BODY_DYNAMIC, &surface, starts[start] + 15.0f * (float)k, sizes[k], 0.0f);
	}
	for (int done = 0; done < steps; done += 60)
	{
		lab_step(lab, 60);
		lab_read(lab);
		for (int k = 0; k < SIZES; ++k)
		{
			double moved = 1e3 * fabs((double)lab->poses[first + k].position.x -
			                          (double)lab->bodies[first + k].def.pose.position.x);
			double speed = done + 60 >= steps ? 1e3 * lab_speed(lab, first + k) : 0.0;
			worst->speed = larger(worst->speed, speed);
			if (!(moved <= worst->moved))
			{
				worst->moved = moved;
				worst->start = start;
				worst->body = k;
			}
		}
	}
	lab_close(lab);
}

static void single(Validation* v, const char* name, int kind)
{
	Worst worst = {0};
	begin(v, "%s", name);
	for (int start = 0; start < (v->quick ? 3 : STARTS); ++start)
		lie(v, kind, start, v->quick ? 1200 : 3600, &worst);
	where(v, "size %g m from x = %g m", (double)sizes[worst.body], (double)starts[worst.start] + 15.0 * worst.body);
	row(v, "moved", worst.moved, "mm", AT_MOST, CREEP);
	row(v, "fastest at the end", worst.speed, "mm/s", AT_MOST, SPEED);
}

typedef struct
{
	double energy, speed; // maxima in one second: mean kinetic energy of a body, J; speed of the fastest body, m/s
	int fastest;
} Calm;

static Calm calm_of(Lab* lab, int first)
{
	Calm calm = {.fastest = first};
	for (int k = 0; k < 60; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		double energy = 0.0;
		for (int n = first; n < lab->count; ++n)
			energy += lab_kinetic(lab, n);
		calm.energy = larger(calm.energy, energy / (lab->count - first));
		int body = first;
		double speed = lab_fastest(lab, &body);
		if (speed > calm.speed)
			calm.fastest = body;
		calm.speed = larger(calm.speed, speed);
	}
	return calm;
}

static void point_at(const Lab* lab, int body)
{
	const scree_shape* shape = &lab->bodies[body].parts[0].surface.shape;
	static const char* const kinds[] = {"circle", "capsule", "segment", "polygon"};
	where(lab->validation, "%s of %d corners at %.2f %.2f", kinds[shape->kind], shape->count,
	      (double)lab->poses[body].position.x, (double)lab->poses[body].position.y);
}

// Returns the arc length that a disk rolled between two poses, by its rotation, m; 0 for other shapes.
static double rolled(const scree_shape* shape, scree_pose from, scree_pose to)
{
	if (shape->kind != SCREE_SHAPE_CIRCLE)
		return 0.0;
	double cosine = (double)from.rotation.c * (double)to.rotation.c + (double)from.rotation.s * (double)to.rotation.s;
	double sine = (double)from.rotation.c * (double)to.rotation.s - (double)from.rotation.s * (double)to.rotation.c;
	return (double)shape->radius * fabs(atan2(sine, cosine));
}

// Prints the largest distance that a body crept, mm per minute. Bodies that moved by more than a quarter of their reach
// are left out. A disk that touches only one body can roll freely, so the distance that the disk rolled is subtracted.
static void creep(Validation* v, Lab* lab, int first, int steps)
{
	scree_pose* before = require_memory(malloc((size_t)lab->count * sizeof *before));
	int* touches = require_memory(malloc((size_t)lab->count * sizeof *touches));
	double most = 0.0;
	int farthest = first;
	for (int k = 0; k < lab->count; ++k)
		before[k] = lab->poses[k];
	lab_step(lab, steps);
	lab_overlap(lab, touches);
	for (int k = first; k < lab->count; ++k)
	{
		const scree_shape* shape = &lab->bodies[k].parts[0].surface.shape;
		double moved = hypot((double)(lab->poses[k].position.x - before[k].position.x),
		                     (double)(lab->poses[k].position.y - before[k].position.y));
		double crept = touches[k] == 1 ? moved - rolled(shape, before[k], lab->poses[k]) : moved;
		if (moved > 0.25 * (double)shape->reach || crept <= most)
			continue;
		most = crept;
		farthest = k;
	}
	free(touches);
	free(before);
	point_at(lab, farthest);
	row(v, "creep a minute", 1e3 * most * 3600.0 / steps, "mm", AT_MOST, CREEP);
}

// Prints the mean kinetic energy and the speed of the fastest body in the last second before step `until`. Then takes
// `behind` steps, and prints the creep in these steps and the deepest overlap after them.
static void print_heap(Validation* v, Lab* lab, int first, const char* name, int until, int behind)
{
	begin(v, "heap of %d %s after %d steps", lab->count - first, name, until);
	v->steps = until;
	Calm calm = calm_of(lab, first);
	v->steps = until;
	row(v, "kinetic energy a body", calm.energy, "J", AT_MOST, ENERGY);
	point_at(lab, calm.fastest);
	row(v, "fastest", 1e3 * calm.speed, "mm/s", AT_MOST, SPEED);
	creep(v, lab, first, behind);
	row(v, "deepest overlap", 1e3 * lab_overlap(lab, NULL), "mm", SHOWN, 0.0);
}

static void heap(Validation* v, int count, bool mixed, double x)
{
	char name[64];
	snprintf(name, sizeof name, "%s%s", mixed ? "mixed bodies" : "boxes and circles", x > 0.0 ? " at x = 100 m" : "");
	int half = v->quick ? 1800 : 3600, all = v->quick ? 0 : 20000, behind = v->quick ? 600 : 3600;
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	int first = add_heap(lab, count, mixed, x);
	lab_step(lab, half - 60);
	print_heap(v, lab, first, name, half, behind);
	if (all > 0)
	{
		lab_step(lab, all - 60 - half - behind);
		print_heap(v, lab, first, name, all, behind);
	}
	lab_close(lab);
}

void rest_experiment(Validation* v)
{
	single(v, "circles", 0);
	single(v, "capsules", 1);
	single(v, "rounded boxes", 2);
	single(v, "boxes", 3);
	heap(v, v->quick ? 60 : 600, true, 0.0);
	if (v->quick)
		return;
	heap(v, 400, true, 0.0);
	heap(v, 2000, true, 0.0);
	heap(v, 600, false, 0.0);
	heap(v, 400, true, 100.0);
}
