// SPDX-License-Identifier: MIT
// scenery.c -- makes a world of random shapes, thin and thick, large and small, and random probes that meet, graze or
// miss them.
#include "scenery.h"
#include "engine_scree.h"
#include "experiment_support.h"
#include <math.h>
#include <string.h>

#define HALF 20.0 // m: half the width of the scenery

static float between(uint64_t* seed, double low, double high) { return (float)random_real(seed, low, high); }
static bool often(uint64_t* seed, double share) { return random_real(seed, 0.0, 1.0) < share; }

static scree_vec any_point(uint64_t* seed, double half)
{
	float x = between(seed, -half, half), y = between(seed, -half, half);
	return (scree_vec){x, y};
}

scree_shape scenery_shape(uint64_t* seed, int kind)
{
	for (;;)
	{
		scree_shape shape;
		double size = often(seed, 0.5) ? random_real(seed, 0.3, 3.0) : pow(10.0, random_real(seed, -2.5, 1.0));
		scree_vec at = any_point(seed, size), to = any_point(seed, size), corners[SCREE_MAX_VERTICES];
		float radius = (float)(size * (often(seed, 0.3) ? 0.01 : random_real(seed, 0.05, 0.5)));
		int count = 3 + (int)random_real(seed, 0.0, SCREE_MAX_VERTICES - 2.0);
		double flat = often(seed, 0.3) ? 0.02 : 1.0;
		for (int k = 0; k < count; ++k)
		{
			scree_vec corner = any_point(seed, size);
			corners[k] = (scree_vec){at.x + corner.x, at.y + (float)flat * corner.y};
		}
		scree_status status = kind == 0   ? scree_shape_make_circle(at, radius, &shape)
		                      : kind == 1 ? scree_shape_make_capsule(at, to, radius, &shape)
		                      : kind == 2 ? scree_shape_make_segment(at, to, &shape)
		                                  : scree_shape_make_hull(corners, count, kind == 3 ? 0.0f : radius, &shape);
		if (status == SCREE_OK)
			return shape;
	}
}

void scenery_ok(const Scenery* s, scree_status status)
{
	if (status == SCREE_OK || s->validation->broken)
		return;
	fprintf(stderr, "scree validate: %s\n", scree_error());
	s->validation->broken = true;
}

bool scenery_is_of(const Validation* v) { return strcmp(v->engine->name, "scree") == 0; }

scree_shape scenery_small(uint64_t* seed)
{
	scree_shape shape;
	do
		shape = scenery_shape(seed, (int)random_real(seed, 0.0, SCENERY_KINDS));
	while (shape.reach > 1.0f);
	return shape;
}

Scenery scenery_empty(Validation* v, double place)
{
	Scenery s = {.validation = v, .place = place, .rounding = 4e-7 * place};
	scree_world_def def = scree_world_def_default();
	engine_set_device(&def, &v->options);
	scenery_ok(&s, scree_world_create(&def, &s.world));
	return s;
}

Scenery scenery_open(Validation* v, uint64_t* seed, double place)
{
	Scenery s = scenery_empty(v, place);
	for (int k = 0; k < SCENERY_SHAPES && !v->broken; ++k)
	{
		scree_attribute_def surface = scree_attribute_def_default();
		scree_collidable_def collidable = scree_collidable_def_default();
		scree_vec at = any_point(seed, HALF);
		surface.shape = s.shapes[k] = scenery_shape(seed, k % SCENERY_KINDS);
		s.poses[k].position = (scree_vec){(float)place + at.x, -(float)place + at.y};
		s.poses[k].rotation = scree_rot_make(often(seed, 0.2) ? 0.0f : between(seed, -3.0, 3.0));
		scenery_ok(&s, scree_attribute_create(s.world, &surface, &collidable.attribute));
		collidable.pose = s.poses[k];
		scenery_ok(&s, scree_collidable_create(s.world, &collidable, &s.handles[k]));
	}
	return s;
}

void scenery_close(Scenery* s) { scree_world_destroy(s->world); }

scree_query_def scenery_query_def(void)
{
	scree_query_def def = scree_query_def_default();
	def.kinds = SCREE_QUERY_FREE;
	return def;
}

scree_probe scenery_probe(const Scenery* s, uint64_t* seed, const scree_shape* shape)
{
	scree_probe probe = {.pose.rotation = scree_rot_make(between(seed, -3.0, 3.0))};
	int k = (int)random_real(seed, 0.0, SCENERY_SHAPES);
	const scree_shape* target = &s->shapes[k];
	scree_pose at = s->poses[k];
	scree_vec start = any_point(seed, often(seed, 0.2) ? 2.0 : HALF);
	bool near = often(seed, 0.3);
	probe.pose.position.x = near ? at.position.x + 0.2f * start.x : (float)s->place + start.x;
	probe.pose.position.y = near ? at.position.y + 0.2f * start.y : -(float)s->place + start.y;
	if (often(seed, 0.4)) // edges of probe and shape are parallel, or nearly parallel
	{
		double turn = often(seed, 0.5) ? 0.0 : pow(10.0, random_real(seed, -7.0, -2.0));
		probe.pose.rotation = scree_rot_make((float)((double)scree_rot_get_angle(at.rotation) + turn));
		probe.pose.rotation = turn == 0.0 ? at.rotation : probe.pose.rotation;
	}
	int i = (int)random_real(seed, 0.0, target->count), j = (i + 1) % target->count;
	float share = between(seed, 0.0, 1.0), c = at.rotation.c, r = at.rotation.s;
	float x = target->vertices[i].x + share * (target->vertices[j].x - target->vertices[i].x);
	float y = target->vertices[i].y + share * (target->vertices[j].y - target->vertices[i].y);
	float beyond = between(seed, 0.3, 2.5), corner = often(seed, 0.5) ? 0.0f : 1.0f;
	probe.translation.x =
	    beyond * (at.position.x + c * x - r * y - probe.pose.position.x - corner * shape->vertices[0].x);
	probe.translation.y =
	    beyond * (at.position.y + r * x + c * y - probe.pose.position.y - corner * shape->vertices[0].y);
	if (often(seed, 0.3))
		probe.translation = any_point(seed, 2.0 * HALF);
	if (often(seed, 0.05))
		probe.translation.x = 0.0f;
	if (often(seed, 0.05))
		probe.translation.y = 0.0f;
	return probe;
}

bool scenery_is_away(const Scenery* s, int k, float reach, const scree_probe* probe)
{
	double px = (double)s->poses[k].position.x - (double)probe->pose.position.x;
	double py = (double)s->poses[k].position.y - (double)probe->pose.position.y;
	double x = (double)probe->translation.x, y = (double)probe->translation.y, square = x * x + y * y;
	double share = square > 0.0 ? fmin(fmax((px * x + py * y) / square, 0.0), 1.0) : 0.0;
	return hypot(px - share * x, py - share * y) > (double)(s->shapes[k].reach + reach) + 0.1;
}
