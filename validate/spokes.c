// SPDX-License-Identifier: MIT
// spokes.c -- simulates wheels of a light hub with heavy spokes, and checks that their joints hold, and that they come
// to rest.
#include "props.h"
#include <math.h>

#define TURN 6.28318530717959
#define THIN 0.08 // m: half the width of a spoke

typedef struct
{
	int spokes, parts; // number of spokes; number of bodies in each spoke
	double ratio;      // inertia of all spokes about the hub, divided by the hub's inertia
	double radius;     // m: radius of the hub
	bool hinged;
	double hertz; // Hz: stiffness of the welds; 0: rigid
} Wheel;

static void join_softly(Lab* lab, bool hinged, double hertz, int a, int b, double x, double y)
{
	scree_joint_def def = scree_joint_def_make(hinged ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD);
	for (int k = 0; k < 3 && !hinged && hertz > 0.0; ++k)
	{
		def.coordinates[k].lock_hertz = (float)hertz;
		def.coordinates[k].lock_damping_ratio = 1.0f;
	}
	const int ends[2] = {a, b};
	scree_pose* const frames[2] = {&def.frame_a, &def.frame_b};
	for (int side = 0; side < 2; ++side)
	{
		scree_pose at = lab->bodies[ends[side]].def.pose;
		double dx = x - (double)at.position.x, dy = y - (double)at.position.y;
		double c = (double)at.rotation.c, s = (double)at.rotation.s;
		*frames[side] =
		    (scree_pose){{(float)(c * dx + s * dy), (float)(c * dy - s * dx)}, {at.rotation.c, -at.rotation.s}};
	}
	lab_join(lab, &def, a, b);
}

static void join(Lab* lab, bool hinged, int a, int b, double x, double y) { join_softly(lab, hinged, 0.0, a, b, x, y); }

// Adds a wheel with its hub at x, y. Each part of a spoke is 2 m long. The bodies of the wheel do not touch each other.
// Returns the index of the hub.
static int add_wheel(Lab* lab, const Wheel* wheel, double x, double y)
{
	scree_attribute_def hub = circle_of(wheel->radius), part = box_of(1.0, THIN);
	double mass = 4.0 * THIN, inertia = 0.0, own = mass * (1.0 + THIN * THIN) / 3.0;
	for (int k = 0; k < wheel->parts; ++k)
		inertia += own + mass * pow(wheel->radius + 1.0 + 2.0 * k, 2.0);
	hub.density = (float)(wheel->spokes * inertia / wheel->ratio / (TURN / 4.0 * pow(wheel->radius, 4.0)));
	int first = lab_put(lab, SCREE_BODY_DYNAMIC, &hub, (float)x, (float)y, 0.0f);
	lab->bodies[lab->count - 1].parts[0].filter.group = -1;
	for (int k = 0; k < wheel->spokes; ++k)
	{
		double angle = TURN * k / wheel->spokes, c = cos(angle), s = sin(angle);
		for (int n = 0, above = first; n < wheel->parts; ++n)
		{
			double from = wheel->radius + 2.0 * n;
			int body = lab_put(lab, SCREE_BODY_DYNAMIC, &part, (float)(x + (from + 1.0) * c),
			                   (float)(y + (from + 1.0) * s), (float)angle);
			lab->bodies[lab->count - 1].parts[0].filter.group = -1;
			join_softly(lab, wheel->hinged, wheel->hertz, above, body, x + from * c, y + from * s);
			above = body;
		}
	}
	return first;
}

// Takes steps for 5 s (quick runs: 2 s) and closes the lab. Checks the widest gap of its joints against the limit
// most_gap, mm (0: no limit), and the fastest spin after the last step against the limit most_spin, rad/s.
static void watch(Validation* v, Lab* lab, double most_gap, double most_spin)
{
	double gap = 0.0, spin = 0.0;
	int steps = v->quick ? 120 : 300;
	for (int k = 0; k < steps; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		gap = larger(gap, lab_gap(lab));
		spin = 0.0;
		for (int n = 0; n < lab->count; ++n)
			spin = larger(spin, fabs((double)lab->velocities[n].angular));
	}
	row(v, "widest gap", 1e3 * gap, "mm", most_gap > 0.0 ? AT_MOST : SHOWN, most_gap);
	row(v, "fastest spin at the end", spin, "rad/s", AT_MOST, most_spin);
	lab_close(lab);
}

static void hang(Validation* v, const Wheel* wheel, bool axle, int substeps, double most_gap, double most_spin)
{
	begin(v, "%d %s %s%s, ratio %g%s, %d substeps", wheel->spokes,
	      wheel->hinged        ? "hinged"
	      : wheel->hertz > 0.0 ? "softly welded"
	                           : "welded",
	      wheel->parts > 1 ? "arms of " : "spokes",
	      wheel->parts == 1   ? ""
	      : wheel->parts == 2 ? "two parts"
	                          : "three parts",
	      wheel->ratio, axle ? " on an axle" : "", substeps);
	LabDef def = lab_def();
	def.substeps = substeps;
	def.gravity.y = axle ? -10.0f : 0.0f;
	Lab* lab = lab_open(v, &def);
	scree_attribute_def post = circle_of(0.05);
	int ground = lab_put(lab, SCREE_BODY_STATIC, &post, 0.0f, 0.0f, 0.0f);
	lab->bodies[lab->count - 1].parts[0].filter.group = -1;
	int hub = add_wheel(lab, wheel, 0.0, 0.0);
	if (axle)
		join(lab, true, ground, hub, 0.0, 0.0);
	watch(v, lab, most_gap, most_spin);
}

// Checks a wheel, either with an axle and gravity or without both. axle: true for the first case.
static void turn(Validation* v, const Wheel* wheel, bool axle, int substeps)
{
	bool rests = !wheel->hinged || !axle;
	hang(v, wheel, axle, substeps, rests ? 5.0 : 10.0, rests ? 0.01 : 30.0);
}

// Checks wheels of welded spokes on an axle. At ratio 10,000,000 rigid welds yield by decimeters, but the bodies come
// to rest. The stiffness of a soft weld is computed from its frequency (hertz) and the effective mass of the hub and
// one spoke. Therefore in both engines a soft weld yields under the weight of the spoke.
static void trees(Validation* v)
{
	for (int parts = 1; parts <= (v->quick ? 1 : 3); ++parts)
	{
		Wheel tree = {.spokes = 8, .parts = parts, .ratio = 1e7, .radius = 0.3};
		hang(v, &tree, true, 4, 250.0, 0.01);
		tree.hertz = 10.0;
		hang(v, &tree, true, 4, 0.0, 5.0);
		tree.ratio = 100.0;
		hang(v, &tree, true, 4, 25.0 * parts, 0.1);
	}
}

// Checks wheels side by side whose hubs are welded to each other. Only the first and the last hub have an axle.
static void row_of_wheels(Validation* v, int count, int substeps)
{
	begin(v, "%d wheels in a row of 6 welded spokes each, ratio 100, %d substeps", count, substeps);
	LabDef def = lab_def();
	def.substeps = substeps;
	Lab* lab = lab_open(v, &def);
	Wheel wheel = {.spokes = 6, .parts = 1, .ratio = 100.0, .radius = 0.5};
	scree_attribute_def post = circle_of(0.05);
	int ground = lab_put(lab, SCREE_BODY_STATIC, &post, 0.0f, 0.0f, 0.0f), last = ground;
	lab->bodies[lab->count - 1].parts[0].filter.group = -1;
	for (int k = 0; k < count; ++k)
	{
		int hub = add_wheel(lab, &wheel, k, 0.0);
		join(lab, k == 0, last, hub, k > 0 ? k - 0.5 : 0.0, 0.0);
		last = hub;
	}
	join(lab, true, ground, last, count - 1, 0.0);
	watch(v, lab, 5.0, 0.01);
}

void spokes_experiment(Validation* v)
{
	static const int counts[] = {4, 16, 64};
	for (int hinged = 0; hinged < 2; ++hinged)
		for (int k = v->quick ? 1 : 0; k < (v->quick ? 2 : 3); ++k)
			for (double ratio = 7.0; ratio < 200.0; ratio *= v->quick ? 100.0 : 4.0)
				for (int substeps = 4; substeps <= (v->quick ? 4 : 8); substeps *= 2)
				{
					Wheel wheel = {.spokes = counts[k], .parts = 1, .ratio = ratio, .radius = 1.0, .hinged = hinged};
					turn(v, &wheel, true, substeps);
				}
	for (int parts = 1; parts <= (v->quick ? 1 : 3); ++parts)
	{
		Wheel torso = {.spokes = 8, .parts = parts, .ratio = 1000.0, .radius = 0.3};
		turn(v, &torso, false, 4);
		turn(v, &torso, true, 4);
	}
	row_of_wheels(v, v->quick ? 2 : 6, 4);
	trees(v);
}
