// SPDX-License-Identifier: MIT
// small.c -- drops bodies of 2 to 20 mm on segments and boxes, and checks that they do not fall through, and come to
// rest.
//
// In each step at 60 Hz, gravity increases the displacement of a body by 2.8 mm, more than the smallest size of 2 mm.
#include "props.h"
#include <math.h>

#define SIZES  6
#define DROPS  5
#define TRACKS (2 * DROPS) // two tracks for each height: on one the body is upright, on the other tilted
#define APART  2.0         // m: distance between tracks
#define HEAP   100

static const double sizes[SIZES] = {0.002, 0.003, 0.005, 0.007, 0.01, 0.02}; // m: sizes of bodies
static const double drops[DROPS] = {0.0, 0.02, 0.1, 0.5, 2.0};               // m: heights of drops
static const int substeps[] = {4, 1, 2, 8};                                  // number per step; quick runs use only two

typedef enum
{
	CUBE,
	CIRCLE,
	PLATE,
	CAPSULE,
	KINDS
} Kind;
static const char* const kinds[KINDS] = {"cubes", "circles", "plates of 0.5 m", "capsules of 0.5 m"};

static scree_attribute_def body_of(Kind kind, double size)
{
	double half = 0.5 * size;
	return kind == CUBE     ? box_of(half, half)
	       : kind == CIRCLE ? circle_of(half)
	       : kind == PLATE  ? box_of(0.25, half)
	                        : capsule_of(0.25, half);
}

// Returns the distance from a body's center down to its lowest point, m.
static double reach_down(Kind kind, double size, scree_rot rotation)
{
	double half = 0.5 * size, c = fabs((double)rotation.c), s = fabs((double)rotation.s);
	return kind == CUBE     ? half * (c + s)
	       : kind == CIRCLE ? half
	       : kind == PLATE  ? half * c + 0.25 * s
	                        : half + 0.25 * s;
}

// Adds a floor whose top is at y = 0. segment: true for a segment, which has no thickness; false for a box.
static void lay_floor(Lab* lab, bool segment)
{
	scree_attribute_def surface = segment ? wall_of(60.0) : box_of(30.0, 0.5);
	lab_put(lab, SCREE_BODY_STATIC, &surface, 0.0f, segment ? 0.0f : -0.5f, segment ? 1.57079633f : 0.0f);
}

typedef struct
{
	int through;
	double speed, overlap; // maxima in the fifth second: speed, m/s; overlap divided by the size
} Fall;

// Drops bodies of a kind and size, and updates *worst. parts: number of substeps per step. For circles and capsules
// only the vertical speed counts, because they may roll.
static void fall(Validation* v, bool segment, Kind kind, double size, int parts, Fall* worst)
{
	LabDef def = lab_def();
	def.substeps = parts;
	Lab* lab = lab_open(v, &def);
	lay_floor(lab, segment);
	scree_attribute_def surface = body_of(kind, size);
	int first = 1;
	for (int k = 0; k < TRACKS; ++k)
	{
		float angle = k % 2 ? 0.3f : 0.0f;
		double y = reach_down(kind, size, scree_rot_make(angle)) + drops[k / 2];
		lab_put(lab, SCREE_BODY_DYNAMIC, &surface, (float)(APART * (k - TRACKS / 2)), (float)y, angle);
	}
	lab_step(lab, 240);
	double speed[TRACKS] = {0}, overlap[TRACKS] = {0};
	for (int step = 0; step < 60; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		for (int k = 0; k < TRACKS; ++k)
		{
			scree_pose pose = lab->poses[first + k];
			double now = kind == CIRCLE || kind == CAPSULE ? fabs((double)lab->velocities[first + k].linear.y)
			                                               : lab_speed(lab, first + k);
			speed[k] = larger(speed[k], now);
			overlap[k] = larger(overlap[k], reach_down(kind, size, pose.rotation) - (double)pose.position.y);
		}
	}
	for (int k = 0; k < TRACKS; ++k)
	{
		bool through = !((double)lab->poses[first + k].position.y > 0.0);
		worst->through += through;
		worst->speed = larger(worst->speed, through ? 0.0 : speed[k]);
		worst->overlap = larger(worst->overlap, through ? 0.0 : overlap[k] / size);
		if (through)
			where(v, "%g mm from %g m, %d substeps", 1e3 * size, drops[k / 2], parts);
	}
	lab_close(lab);
}

static void fall_all(Validation* v, bool segment, Kind kind)
{
	begin(v, "%s of 2 to 20 mm dropped on a %s", kinds[kind], segment ? "segment" : "box");
	Fall worst = {0};
	for (int k = 0; k < SIZES; ++k)
		for (int n = 0; n < (v->quick ? 2 : 4); ++n)
			fall(v, segment, kind, sizes[k], substeps[n], &worst);
	row(v, "fell through", worst.through, "", AT_MOST, 0.0);
	row(v, "fastest after 4 s", 1e3 * worst.speed, "mm/s", AT_MOST, 10.0);
	row(v, "deepest overlap of the size", worst.overlap, "", AT_MOST, 1.0);
}

// Drops 100 bodies, ten rows of ten, into a bin whose width is 16 times their size. Checks that they stay in the bin
// and come to rest.
static void heap(Validation* v, bool circles, double size)
{
	begin(v, "heap of %d %s of %g mm", HEAP, circles ? "circles" : "cubes", 1e3 * size);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	lay_floor(lab, false);
	scree_attribute_def side = box_of(0.5, 2.0), surface = body_of(circles ? CIRCLE : CUBE, size);
	for (int k = -1; k < 2; k += 2)
		lab_put(lab, SCREE_BODY_STATIC, &side, (float)(k * (0.5 + 8.0 * size)), 2.0f, 0.0f);
	int first = lab->count;
	uint64_t seed = 1;
	for (int k = 0; k < HEAP; ++k)
	{
		double x = 1.45 * size * (k % 10 - 4.5) + random_real(&seed, 0.0, 0.1 * size), y = 1.5 * size * (k / 10 + 1);
		lab_put(lab, SCREE_BODY_DYNAMIC, &surface, (float)x, (float)y, 0.0f);
	}
	lab_step(lab, 300);
	double fastest = 0.0;
	for (int step = 0; step < 60; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		fastest = larger(fastest, lab_fastest(lab, NULL));
	}
	int out = 0;
	for (int k = first; k < lab->count; ++k)
		out += !(lab->poses[k].position.y > 0.0f && fabs((double)lab->poses[k].position.x) < 8.0 * size);
	row(v, "left the bin", out, "", AT_MOST, 0.0);
	row(v, "fastest after 5 s", 1e3 * fastest, "mm/s", AT_MOST, 10.0);
	row(v, "deepest overlap of the size", lab_overlap(lab, NULL) / size, "", AT_MOST, 1.0);
	lab_close(lab);
}

// Drops ten plates onto each other, and checks that they keep their order. One pair may change places, because
// continuous collision can stop the lower plate of a pair within the step; with Box2D up to four pairs change places.
static void stack(Validation* v, double size)
{
	begin(v, "ten plates of 1 m x %g mm fall onto each other", 1e3 * size);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	lay_floor(lab, true);
	scree_attribute_def plate = box_of(0.5, 0.5 * size);
	for (int k = 0; k < 10; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &plate, 0.01f * (float)(k % 3), (float)(1.5 * size * (k + 0.5) + 0.01), 0.0f);
	lab_step(lab, 300);
	lab_read(lab);
	int crossed = 0;
	for (int k = 1; k < lab->count; ++k)
		crossed += !(lab->poses[k].position.y > (k > 1 ? lab->poses[k - 1].position.y : 0.0f));
	row(v, "out of order", crossed, "", AT_MOST, 1.0);
	row(v, "fastest after 5 s", 1e3 * lab_fastest(lab, NULL), "mm/s", AT_MOST, 10.0);
	lab_close(lab);
}

void small_experiment(Validation* v)
{
	for (int segment = 1; segment >= 0; --segment)
		for (int kind = 0; kind < KINDS; ++kind)
			fall_all(v, segment, (Kind)kind);
	for (int k = 0; k < SIZES - 1; ++k)
	{
		heap(v, false, sizes[k]);
		heap(v, true, sizes[k]);
		stack(v, sizes[k]);
	}
}
