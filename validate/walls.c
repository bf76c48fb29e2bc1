// SPDX-License-Identifier: MIT
// walls.c -- throws bodies at static walls and into wedges: checks that no body crosses a wall, or gains speed in a
// wedge.
//
// Each run has its own track in one world without gravity. A wall is a segment, which has no thickness, or a
// box of 2 cm.
#include "props.h"
#include <math.h>

#define APART  12.0 // m: distance between tracks
#define HEIGHT 14.0 // m: height of a wall; more than APART, so that there are no gaps between walls

typedef enum
{
	BOX,
	CAPSULE,
	ROD,
	CIRCLE,
	KINDS
} Kind;
static const char* const kinds[KINDS] = {"boxes", "capsules", "rods", "circles"};

static scree_attribute_def body_of(Kind kind, double size)
{
	switch (kind)
	{
	case BOX:
		return box_of(size, size);
	case CAPSULE:
		return capsule_of(size, 0.5 * size);
	case ROD:
		return box_of(4.0 * size, 0.25 * size);
	default:
		return circle_of(size);
	}
}

// Returns the longest side of a body, m.
static double length_of(Kind kind, double size) { return (kind == CAPSULE ? 3.0 : kind == ROD ? 8.0 : 2.0) * size; }

static scree_attribute_def wall(bool thick) { return thick ? box_of(0.01, 0.5 * HEIGHT) : wall_of(HEIGHT); }

static Lab* open_empty(Validation* v)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	return lab_open(v, &def);
}

// Adds walls above and below the walls of the tracks, so that no body passes around them.
static void close_off(Lab* lab, const scree_attribute_def* barrier, int runs)
{
	for (int k = 1; k <= 20; ++k)
	{
		lab_put(lab, SCREE_BODY_STATIC, barrier, 0.0f, (float)(APART * (-runs / 2 - k)), 0.0f);
		lab_put(lab, SCREE_BODY_STATIC, barrier, 0.0f, (float)(APART * (runs - runs / 2 - 1 + k)), 0.0f);
	}
}

// Returns the number of bodies behind the wall. If there are any, the next row names the run of the first of them.
static int crossed(Lab* lab, const int* bodies, int count, double speed)
{
	int through = 0;
	lab_read(lab);
	for (int k = count - 1; k >= 0; --k)
	{
		if (lab->poses[bodies[k]].position.x > 0.0f)
		{
			++through;
			where(lab->validation, "%g m/s run %d of %d", speed, k, count);
		}
	}
	return through;
}

// Throws a heavy box at a light box, which is at rest before a wall.
static void strike(Validation* v, bool thick, double speed, int runs)
{
	begin(v, "light box struck at %g m/s before a %s", speed, thick ? "box of 2 cm" : "segment");
	Lab* lab = open_empty(v);
	scree_attribute_def barrier = wall(thick), light = box_of(0.05, 0.05), heavy = box_of(0.2, 0.2);
	heavy.density = 50.0f;
	int bodies[2048];
	uint64_t seed = 13;
	for (int k = 0; k < runs; ++k)
	{
		float y = (float)(APART * (k - runs / 2));
		double gap = 0.2 + 0.2 * (k + 0.37) / runs; // m: distance from the center of the light box to the wall
		lab_put(lab, SCREE_BODY_STATIC, &barrier, 0.0f, y, 0.0f);
		bool plain = k % 2 == 0; // false: the light box is rotated, and the heavy box hits it off center
		double angle = plain ? 0.0 : random_real(&seed, -1.0, 1.0), off = plain ? 0.0 : random_real(&seed, -0.2, 0.2);
		bodies[2 * k] = lab_put(lab, SCREE_BODY_DYNAMIC, &light, (float)-gap, y, (float)angle);
		bodies[2 * k + 1] =
		    lab_throw(lab, &heavy, -1.5f, y + (float)off, 0.0f, (scree_velocity){{(float)speed, 0.0f}, 0.0f});
	}
	close_off(lab, &barrier, runs);
	lab_step(lab, 30);
	int through = crossed(lab, bodies, 2 * runs, speed);
	row(v, "through the wall", through, "", AT_MOST, 0.0);
	lab_close(lab);
}

// Throws bodies at a wall with random angles and angular velocities.
static void throw_at(Validation* v, Kind kind, double size, bool thick, int runs)
{
	static const double speeds[] = {100.0, 200.0, 400.0};
	int through = 0, all = 0, bodies[1024];
	uint64_t seed = 11;
	begin(v, "%s of %g m at 100 to 400 m/s against a %s", kinds[kind], length_of(kind, size),
	      thick ? "box of 2 cm" : "segment");
	for (int s = 0; s < 3; ++s)
	{
		Lab* lab = open_empty(v);
		scree_attribute_def barrier = wall(thick), body = body_of(kind, size);
		for (int k = 0; k < runs; ++k)
		{
			float y = (float)(APART * (k - runs / 2)), angle = (float)random_real(&seed, -3.0, 3.0);
			double x = -3.0 - random_real(&seed, 0.0, speeds[s] / 60.0), spin = random_real(&seed, -30.0, 30.0);
			lab_put(lab, SCREE_BODY_STATIC, &barrier, 0.0f, y, 0.0f);
			bodies[k] =
			    lab_throw(lab, &body, (float)x, y, angle, (scree_velocity){{(float)speeds[s], 0.0f}, (float)spin});
		}
		close_off(lab, &barrier, runs);
		lab_step(lab, 30);
		through += crossed(lab, bodies, runs, speeds[s]);
		all += runs;
		lab_close(lab);
	}
	if (!through)
		where(v, "of %d", all);
	row(v, "through the wall", through, "", AT_MOST, 0.0);
}

// Returns half of the angle between the walls of a run, rad.
static double opening(int run, int runs) { return 0.1 + 0.4 * run / runs; }

// Adds two walls of 4 m that meet at x = 0. half: angle between each wall and the x axis, rad.
static void put_wedge(Lab* lab, bool thick, double y, double half)
{
	scree_attribute_def side = thick ? box_of(0.01, 2.0) : wall_of(4.0);
	// the angle of a body is 0 if its wall is vertical
	for (int s = -1; s <= 1; s += 2)
		lab_put(lab, SCREE_BODY_STATIC, &side, (float)(-2.0 * cos(half)), (float)(y + s * 2.0 * sin(half)),
		        (float)(s * (1.57079633 - half)));
}

// Throws a box of 30 cm into the corner between two walls. The angle between the walls grows from run to run.
static void wedge(Validation* v, bool thick, double speed, int runs)
{
	begin(v, "box of 30 cm shot at %g m/s into a wedge of %s", speed, thick ? "boxes of 2 cm" : "segments");
	Lab* lab = open_empty(v);
	scree_attribute_def box = box_of(0.15, 0.15);
	int bodies[512], out = 0, fastest_run = 0;
	uint64_t seed = 5;
	double fastest = 0.0;
	for (int k = 0; k < runs; ++k)
	{
		double y = APART * (k - runs / 2), half = opening(k, runs);
		put_wedge(lab, thick, y, half);
		bodies[k] = lab_throw(lab, &box, -3.5f, (float)(y + random_real(&seed, -0.05, 0.05)),
		                      (float)random_real(&seed, -0.8, 0.8), (scree_velocity){{(float)speed, 0.0f}, 0.0f});
	}
	bool crossed_once[512] = {false};
	for (int step = 0; step < 60; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		for (int k = 0; k < runs; ++k)
		{
			scree_vec p = lab->poses[bodies[k]].position;
			double y = fabs((double)p.y - APART * (k - runs / 2)), x = -(double)p.x, half = opening(k, runs);
			if (lab_speed(lab, bodies[k]) > fastest)
				fastest_run = k;
			fastest = larger(fastest, lab_speed(lab, bodies[k]));
			// in front of the wedge the box may be at any y; in the wedge it must be between the walls
			crossed_once[k] = crossed_once[k] || (x < 4.0 * cos(half) - 0.3 && y > x * tan(half) + 0.01);
		}
	}
	where(v, "half angle %.3f rad", opening(fastest_run, runs));
	row(v, "fastest", fastest, "m/s", AT_MOST, 1.01 * speed);
	for (int k = runs - 1; k >= 0; --k)
	{
		if (!crossed_once[k])
			continue;
		++out;
		where(v, "half angle %.3f rad of %d", opening(k, runs), runs);
	}
	row(v, "through the walls", out, "", AT_MOST, 0.0);
	lab_close(lab);
}

// Throws disks with friction into the corner of a wedge, and checks the depth of their overlap with the walls after
// 2 s.
static void jam(Validation* v, bool thick, double speed, int runs)
{
	begin(v, "disk of 50 cm shot at %g m/s into the corner of a wedge of %s", speed,
	      thick ? "boxes of 2 cm" : "segments");
	Lab* lab = open_empty(v);
	scree_attribute_def disk = circle_of(0.25);
	int bodies[512];
	for (int k = 0; k < runs; ++k)
	{
		double y = APART * (k - runs / 2), half = opening(k, runs);
		put_wedge(lab, thick, y, half);
		bodies[k] = lab_throw(lab, &disk, -8.0f, (float)y, 0.0f, (scree_velocity){{(float)speed, 0.0f}, 0.0f});
	}
	lab_step(lab, 120);
	lab_read(lab);
	double deepest = 0.0;
	for (int k = 0; k < runs; ++k)
	{
		double half = opening(k, runs), y = fabs((double)lab->poses[bodies[k]].position.y - APART * (k - runs / 2));
		double depth =
		    0.25 + (thick ? 0.01 : 0.0) + (double)lab->poses[bodies[k]].position.x * sin(half) + y * cos(half);
		if (!(depth <= deepest) && lab->poses[bodies[k]].position.x > -4.0f * (float)cos(half))
		{
			deepest = depth;
			where(v, "half angle %.3f rad of %d", half, runs);
		}
	}
	row(v, "depth in the walls after 2 s", 1e3 * deepest, "mm", AT_MOST, 30.0);
	lab_close(lab);
}

void walls_experiment(Validation* v)
{
	static const double speeds[] = {60.0, 30.0, 120.0, 240.0, 400.0};
	static const double rushes[] = {40.0, 60.0, 100.0, 200.0};
	int runs = v->quick ? 40 : 256;
	for (int s = 0; s < (v->quick ? 1 : 5); ++s)
		for (int thick = 0; thick < 2; ++thick)
			strike(v, thick, speeds[s], runs);
	for (Kind kind = BOX; kind < KINDS; ++kind)
		for (int thick = 0; thick < (v->quick ? 1 : 2); ++thick)
		{
			throw_at(v, kind, 0.1, thick, runs);
			if (!v->quick)
				throw_at(v, kind, 0.4, thick, runs);
		}
	for (int s = 0; s < (v->quick ? 1 : 4); ++s)
		for (int thick = 0; thick < 2; ++thick)
			wedge(v, thick, rushes[s], v->quick ? 60 : 200);
	for (int s = 0; s < (v->quick ? 1 : 2); ++s)
		for (int thick = 0; thick < 2; ++thick)
			jam(v, thick, s == 0 ? 200.0 : 50.0, runs);
}
