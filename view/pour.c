// SPDX-License-Identifier: MIT
// pour.c -- pours bodies into a world where there is room. The new bodies have attributes of the scene's bodies.
#include "view/pour.h"
#include <math.h>
#include <stdlib.h>

#define SAMPLES 256       // maximum number of bodies that are examined to find attributes
#define LARGE   4.0f      // maximum reach of poured bodies, divided by the reach of a typical body
#define APART   2.05f     // minimum distance between poured bodies, divided by the reach of a typical body
#define TURN    2.399963f // rad: golden angle, between successive places; its multiples cover all directions evenly
#define SHARE   0.618034f // increase of (distance / radius)^2 from place to place, modulo 1; covers the disk evenly

static const Color water = {52, 116, 178};

typedef struct
{
	scree_attribute attribute;
	float reach; // m: reach of the shape
} Sample;

// If a body is dynamic and has one shape, which is not a sensor, fills a sample from it and returns true.
static bool take_sample(const scree_world* world, scree_body body, Sample* sample)
{
	scree_body_type type;
	scree_collidable collidable;
	scree_attribute_def def;
	uint32_t sees;
	int shapes = 0;
	if (scree_body_get_type(world, body, &type) != SCREE_OK || type != SCREE_BODY_DYNAMIC ||
	    scree_body_get_collidables(world, body, &collidable, 1, &shapes) != SCREE_OK || shapes != 1 ||
	    scree_collidable_get_sensor(world, collidable, &sees) != SCREE_OK || sees ||
	    scree_collidable_get_attribute(world, collidable, &sample->attribute) != SCREE_OK ||
	    scree_attribute_get_def(world, sample->attribute, &def) != SCREE_OK)
		return false;
	sample->reach = def.shape.reach;
	return true;
}

static int compare_reaches(const void* a, const void* b)
{
	float x = ((const Sample*)a)->reach, y = ((const Sample*)b)->reach;
	return (x > y) - (x < y);
}

static void add_kind(Pour* pour, scree_attribute attribute)
{
	for (int k = 0; k < pour->kind_count; ++k)
		if (pour->kinds[k].index == attribute.index)
			return;
	if (pour->kind_count < POUR_KINDS)
		pour->kinds[pour->kind_count++] = attribute;
}

static void find_kinds(Pour* pour, const scree_world* world, const scree_body* bodies, int body_count)
{
	Sample samples[SAMPLES], sorted[SAMPLES];
	int every = (body_count + SAMPLES - 1) / SAMPLES, count = 0;
	for (int k = 0; k < body_count; k += every)
		count += take_sample(world, bodies[k], &samples[count]);
	for (int k = 0; k < count; ++k)
		sorted[k] = samples[k];
	qsort(sorted, (size_t)count, sizeof *sorted, compare_reaches);
	pour->size = count > 0 ? sorted[count / 2].reach : 0.0f;
	for (int k = 0; k < count; ++k)
		if (samples[k].reach <= LARGE * pour->size)
			add_kind(pour, samples[k].attribute);
}

scree_status pour_begin(Pour* pour, scree_world* world)
{
	int count = 0;
	pour->kind_count = 0;
	scree_status status = scree_world_get_bodies(world, NULL, 0, &count);
	scree_body* bodies = malloc(((size_t)count + 1) * sizeof *bodies);
	if (status == SCREE_OK && bodies)
		status = scree_world_get_bodies(world, bodies, count, &count);
	if (status == SCREE_OK && bodies)
		find_kinds(pour, world, bodies, count);
	free(bodies);
	pour->on = pour->due = pour->kind_count > 0;
	return status;
}

void pour_end(Pour* pour) { pour->on = false; }

// Returns the radius of the disk in which bodies are poured, m.
static float radius_of(const Pour* pour) { return APART * pour->size * sqrtf((float)pour->rate); }

// Chooses at most Pour.rate places in the disk. The distance between any two is more than APART times the typical
// reach. Returns the number of places.
static int choose_places(const Pour* pour, scree_vec middle, scree_probe* probes)
{
	float radius = radius_of(pour);
	int count = 0;
	for (int k = 0; k < 4 * pour->rate && count < pour->rate; ++k)
	{
		int turn = pour->poured + k;
		float angle = TURN * (float)turn, away = radius * sqrtf(fmodf(SHARE * (float)turn, 1.0f));
		scree_vec at = {middle.x + away * cosf(angle), middle.y + away * sinf(angle)};
		bool free = fabsf(at.x) < SCREE_MAX_COORDINATE && fabsf(at.y) < SCREE_MAX_COORDINATE;
		for (int n = 0; n < count && free; ++n)
			free = hypotf(at.x - probes[n].pose.position.x, at.y - probes[n].pose.position.y) > APART * pour->size;
		if (free)
			probes[count++] = (scree_probe){.pose = {at, {cosf(angle), sinf(angle)}}};
	}
	return count;
}

scree_status pour_step(Pour* pour, scree_world* world, scree_vec at, bool* added)
{
	scree_probe probes[POUR_MOST];
	scree_body_def defs[POUR_MOST];
	scree_shape circle;
	scree_query_results list;
	if (!pour->on && !pour->due)
		return SCREE_OK;
	pour->due = false;
	int count = choose_places(pour, at, probes), made = 0;
	pour->poured += count > 0 ? count : 1;
	if (count == 0)
		return SCREE_OK;
	scree_status status = scree_shape_make_circle((scree_vec){0, 0}, pour->size, &circle);
	if (status == SCREE_OK)
		status = scree_world_list_shapes(world, NULL, &circle, probes, count, &list);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		if (list.first[k + 1] > list.first[k])
			continue;
		defs[made] = scree_body_def_default();
		defs[made].attribute = pour->kinds[(pour->poured + k) % pour->kind_count];
		defs[made++].pose = probes[k].pose;
	}
	if (status == SCREE_OK && made > 0)
		status = scree_bodies_create(world, defs, made, NULL);
	*added = *added || (status == SCREE_OK && made > 0);
	pour->on = pour->on && status == SCREE_OK;
	return status;
}

void pour_mark(const Pour* pour, Strokes* strokes, scree_vec at, float scale)
{
	if (pour->on)
		strokes_ring(strokes, at, 2.0f * radius_of(pour) * scale, 1.5f, water, 200);
}
