// SPDX-License-Identifier: MIT
// platforms.c -- one-way platforms in a ring hold the bodies that are stirred in it, as solid platforms do.
//
// A bar turns in a ring with a radius of 10 m and drives bodies over the seams of the platforms. In engines without
// one-way platforms the platforms are solid.
#include "props.h"
#include <math.h>

#define RADIUS  10.0 // m: radius of the ring
#define THICK   0.3  // m: thickness of platforms that are boxes
#define STIRRED 300

typedef struct
{
	const char* name;
	bool thick, apart, moves; // true: platforms are boxes; each has its own body; the ring is kinematic
	int sides;
	double spin, sways; // rad/s: angular velocity of the bar; factor of the swaying velocity of ring and bar
} Ring;

static const Ring rings[] = {
    {"60 segments", false, false, false, 60, 2.0, 0.0},
    {"60 segments", false, false, false, 60, 5.0, 0.0},
    {"60 segments", false, false, false, 60, 10.0, 0.0},
    {"20 segments", false, false, false, 20, 20.0, 0.0},
    {"60 segments of a body each", false, true, false, 60, 10.0, 0.0},
    {"60 boxes", true, false, false, 60, 10.0, 0.0},
    {"20 boxes", true, false, false, 20, 20.0, 0.0},
    {"60 kinematic segments", false, false, true, 60, 10.0, 0.0},
    {"60 segments that sway", false, false, true, 60, 2.0, 1.0},
    {"60 boxes that sway", true, false, true, 60, 2.0, 1.0},
    {"60 segments that sway", false, false, true, 60, 10.0, 1.0},
    {"60 boxes that sway", true, false, true, 60, 10.0, 1.0},
};
#define RINGS (int)(sizeof rings / sizeof rings[0])

static scree_vec on_circle(double radius, double angle)
{
	return (scree_vec){(float)(radius * cos(angle)), (float)(radius * sin(angle))};
}

// Returns the platform of a ring between two angles, rad. The platform is solid from inside.
static EnginePart part_of(const Ring* ring, double from, double to)
{
	scree_vec corners[4] = {on_circle(RADIUS, from), on_circle(RADIUS, to), on_circle(RADIUS + THICK, to),
	                        on_circle(RADIUS + THICK, from)};
	EnginePart part = {.filter = scree_filter_default()};
	part.surface = scree_attribute_def_default();
	if (ring->thick)
		part.surface = polygon_of(corners, 4);
	else
		scree_shape_make_segment(corners[0], corners[1], &part.surface.shape);
	part.surface.one_way = on_circle(-1.0, 0.5 * (from + to));
	return part;
}

static void add_ring(Lab* lab, const Ring* ring)
{
	EnginePart parts[64];
	scree_body_def def = scree_body_def_default();
	def.type = ring->moves ? SCREE_BODY_KINEMATIC : SCREE_BODY_STATIC;
	for (int k = 0; k < ring->sides; ++k)
	{
		double turn = 6.283185307 / ring->sides;
		parts[k] = part_of(ring, turn * k, turn * (k + 1));
		if (ring->apart)
			lab_add(lab, &def, parts + k, 1);
	}
	if (!ring->apart)
		lab_add(lab, &def, parts, ring->sides);
}

static void stir(Validation* v, const Ring* ring, const char* name, scree_attribute_def surface)
{
	begin(v, "%s in a ring of %s, a bar at %g rad/s", name, ring->name, ring->spin);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	add_ring(lab, ring);
	scree_attribute_def rod = box_of(9.0, 0.2);
	int bar = lab_put(lab, SCREE_BODY_KINEMATIC, &rod, 0.0f, 0.0f, 0.0f), first = lab->count;
	for (int k = 0; k < 1600 && lab->count < first + STIRRED; ++k)
	{
		double x = -9.0 + 0.65 * (k % 40), y = -9.0 + 0.65 * (k / 40);
		if (hypot(x, y) < 9.2 && fabs(y) > 0.7)
			lab_put(lab, SCREE_BODY_DYNAMIC, &surface, (float)x, (float)y, 0.0f);
	}
	for (int step = 0; step < (v->quick ? 120 : 600); ++step)
	{
		double t = step / 60.0;
		scree_vec way = {(float)(ring->sways * 3.0 * cos(2.0 * t)), (float)(ring->sways * 2.0 * cos(3.0 * t))};
		lab_set_velocity(lab, bar, (scree_velocity){way, (float)ring->spin});
		for (int k = 0; ring->moves && k < bar; ++k)
			lab_set_velocity(lab, k, (scree_velocity){way, 0.0f});
		lab_step(lab, 1);
	}
	lab_read(lab);
	int out = 0;
	for (int k = first; k < lab->count; ++k)
	{
		scree_vec at = lab->poses[k].position, middle = lab->poses[bar].position;
		out += hypot((double)(at.x - middle.x), (double)(at.y - middle.y)) > RADIUS + 0.5;
	}
	row(v, "left the ring", out, "", AT_MOST, 0.0);
	lab_close(lab);
}

void platforms_experiment(Validation* v)
{
	for (int k = 0; k < RINGS; ++k)
	{
		stir(v, rings + k, "circles", circle_of(0.3));
		if (v->quick)
			continue;
		stir(v, rings + k, "boxes", box_of(0.3, 0.2));
		stir(v, rings + k, "capsules", capsule_of(0.15, 0.15));
	}
}
