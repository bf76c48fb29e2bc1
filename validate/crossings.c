// SPDX-License-Identifier: MIT
// crossings.c -- thin fast bodies do not pass through a thin wall that is a dynamic body.
//
// All trials are in one world without gravity, each at its own place: an upright wall of 4 m that can move, and a body
// that is thrown at its middle. A body crosses if its center moves to the other side of the wall's middle plane,
// between the ends of the wall, and stays there. A body that goes around an end of the wall is not checked further. In
// Box2D the thrown bodies are bullets.
#include "props.h"
#include <math.h>
#include <stdlib.h>

#define APART 15.0 // m: distance between trials
#define HALF  2.0  // m: half the height of a wall
#define STEPS 20
// trials in a row; a single row would be too long, because coordinates far from the origin are rounded
#define COLUMN 64

typedef enum
{
	ROD,
	CAPSULE,
	BALL,
	KINDS
} Kind;
static const char* const kinds[KINDS] = {"rods of 6 cm that spin at 50 rad/s", "capsules", "balls of 6 cm"};

typedef struct
{
	int wall, body;
	int side;   // -1 or 1: side of the wall's middle plane on which the body began
	bool gone;  // true: the body went around an end of the wall
	bool there; // true: the body is on the other side of the wall
} Trial;

static scree_attribute_def body_of(Kind kind)
{
	switch (kind)
	{
	case ROD:
		return box_of(0.4, 0.03);
	case CAPSULE:
		return capsule_of(0.15, 0.03);
	default:
		return circle_of(0.03);
	}
}

// Returns the center of a body in the frame of its wall.
static scree_vec in_wall(const Lab* lab, const Trial* t)
{
	scree_pose wall = lab->poses[t->wall], body = lab->poses[t->body];
	float x = body.position.x - wall.position.x, y = body.position.y - wall.position.y;
	return (scree_vec){wall.rotation.c * x + wall.rotation.s * y, wall.rotation.c * y - wall.rotation.s * x};
}

static void look(const Lab* lab, Trial* t)
{
	scree_vec at = in_wall(lab, t);
	t->gone = t->gone || fabs((double)at.y) > HALF - 0.1;
	if (!t->gone)
		t->there = (at.x > 0.0f ? 1 : -1) != t->side;
}

// Throws bodies at walls of this thickness, m, and prints the number of bodies that crossed. density: density of the
// walls divided by that of the bodies.
static void throw_at(Validation* v, Kind kind, double thickness, double density, double slow, double fast, int runs)
{
	begin(v, "%s at %g to %g m/s against dynamic walls of %g cm, density %g", kinds[kind], slow, fast,
	      100.0 * thickness, density);
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	def.bullets = true;
	Lab* lab = lab_open(v, &def);
	scree_attribute_def barrier = box_of(0.5 * thickness, HALF), body = body_of(kind);
	barrier.density = (float)density;
	Trial* trials = require_memory(calloc((size_t)runs, sizeof *trials));
	uint64_t seed = 17;
	for (int k = 0; k < runs; ++k)
	{
		double x = APART * (k % COLUMN - COLUMN / 2), y = APART * (k / COLUMN - runs / COLUMN / 2);
		double speed = random_real(&seed, slow, fast), angle = random_real(&seed, -3.14, 3.14);
		double off = random_real(&seed, -1.0, 1.0), spin = random_real(&seed, -20.0, 20.0);
		double away = 0.6 + random_real(&seed, 0.0, speed / 60.0), slant = random_real(&seed, -0.3, 0.3);
		if (kind == ROD)
			spin = spin < 0.0 ? -50.0 : 50.0;
		trials[k].wall = lab_put(lab, SCREE_BODY_DYNAMIC, &barrier, (float)x, (float)y, 0.0f);
		trials[k].body = lab_throw(lab, &body, (float)(x - away), (float)(y + off - away * slant), (float)angle,
		                           (scree_velocity){{(float)speed, (float)(speed * slant)}, (float)spin});
		trials[k].side = -1;
	}
	for (int step = 0; step < STEPS; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		for (int k = 0; k < runs; ++k)
			look(lab, &trials[k]);
	}
	int through = 0;
	for (int k = runs - 1; k >= 0; --k)
	{
		if (!trials[k].there)
			continue;
		++through;
		where(v, "trial %d of %d", k, runs);
	}
	// walls of low density have no limit, because light walls that are hit turn by half a radian per step
	row(v, "through the wall", through, "", density > 5.0 ? AT_MOST : SHOWN, 0.0);
	lab_close(lab);
	free(trials);
}

void crossings_experiment(Validation* v)
{
	static const double thicknesses[] = {0.02, 0.06, 0.1}, densities[] = {1.0, 10.0, 100.0};
	int runs = v->quick ? 20 : 560;
	for (Kind kind = ROD; kind < KINDS; ++kind)
		for (int t = 0; t < 3; ++t)
			for (int d = v->quick ? 1 : 0; d < (v->quick ? 2 : 3); ++d)
				throw_at(v, kind, thicknesses[t], densities[d], kind == ROD ? 2.0 : 50.0, kind == ROD ? 60.0 : 200.0,
				         runs);
}
