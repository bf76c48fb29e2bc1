// SPDX-License-Identifier: MIT
// query.c -- queries with one answer each: the first, any, or the nearest collidable.
#include "api/query.h"
#include "world/auto.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/geometry.h"
#include "world/handles.h"
#include "world/upload.h"
#include <stddef.h>
#include <string.h>

// the device reads and writes the user's arrays
_Static_assert(sizeof(scree_ray) == sizeof(Query) && offsetof(scree_ray, ignored) == offsetof(Query, ignored) &&
                   offsetof(scree_ray, radius) == offsetof(Query, b),
               "a ray is a Query");
_Static_assert(sizeof(scree_probe) == sizeof(Query) && offsetof(scree_probe, ignored) == offsetof(Query, ignored) &&
                   offsetof(scree_probe, translation) == offsetof(Query, b),
               "a probe is a Query");
_Static_assert(sizeof(scree_found) == sizeof(Found) && offsetof(scree_found, fraction) == offsetof(Found, fraction) &&
                   offsetof(scree_found, hit) == offsetof(Found, marks),
               "an answer is a Found");

#define ALL_BITS (~(uint64_t)0)
#define ALL_KINDS \
	(SCREE_QUERY_STATIC | SCREE_QUERY_KINEMATIC | SCREE_QUERY_DYNAMIC | SCREE_QUERY_FREE | SCREE_QUERY_SENSORS)

static const DefinitionType query_definition = {
    sizeof(scree_query_def), offsetof(scree_query_def, skip_inside) + sizeof(bool), "scree_query_def_default"};

void scree_query_def_default_sized(scree_query_def* def, size_t size)
{
	scree_query_def made = {.size = (uint32_t)size,
	                        .kinds = SCREE_QUERY_STATIC | SCREE_QUERY_KINEMATIC | SCREE_QUERY_DYNAMIC,
	                        .category = ALL_BITS,
	                        .mask = ALL_BITS};
	write_result(def, size, &made, sizeof made);
}

scree_status query_check(scree_world* world, const char* function, const scree_query_def* def, const void* items,
                         const char* items_name, int count, Questions* questions)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, items_name, items, count));
	scree_query_def local;
	if (def)
	{
		Where at = {function, "def", ALONE};
		TRY(check_definition(at, def, 0, &query_definition));
		def = definition_at(def, 0, &query_definition, &local);
		if (def->kinds & ~(uint32_t)ALL_KINDS)
			return refuse(SCREE_ERROR_INVALID, at, ".kinds", "is %u, has bits other than SCREE_QUERY_*", def->kinds);
	}
	else
	{
		scree_query_def_default_sized(&local, sizeof local);
		def = &local;
	}
	*questions = (Questions){.plan = {.category = def->category,
	                                  .mask = def->mask,
	                                  .kinds = def->kinds,
	                                  .skips = def->skip_inside,
	                                  .all = def->category == ALL_BITS && def->mask == ALL_BITS},
	                         .any = def->any,
	                         .items = items,
	                         .count = count,
	                         .generation = world->collidables.generation,
	                         .collidables = world->collidables.used,
	                         .version = world->collidables.changes,
	                         .timings = world->def.timings};
	return SCREE_OK;
}

#define MAGNITUDE 0x7fffffffu

typedef uint32_t Words4 __attribute__((vector_size(16))); // half of a ray or a probe

typedef struct // of each word: the bits that count, and the most that they may be as a whole number
{
	Words4 counts[2], most[2];
} Plain;

// How many of the items up to count are surely in bounds. Floats that are not negative are ordered like their bits, NaN behind
// infinity; a word above its bound leaves the highest bit. With comparisons of floats a million rays took 6 ms.
static int plain_items(const void* items, int count, const Plain* plain)
{
	enum
	{
		BLOCK = 64
	};
	for (int k = 0; k < count; k += BLOCK)
	{
		Words4 odd = {0}, words[2];
		int end = count - k < BLOCK ? count : k + BLOCK;
		for (int i = k; i < end; ++i)
		{
			memcpy(words, (const char*)items + sizeof words * (size_t)i, sizeof words);
			words[0] &= plain->counts[0];
			words[1] &= plain->counts[1];
			odd |= words[0] | (plain->most[0] - words[0]) | words[1] | (plain->most[1] - words[1]);
		}
		if ((odd[0] | odd[1] | odd[2] | odd[3]) >> 31)
			return k;
	}
	return count;
}

static uint32_t bits_of(float x) { return (uint32_t)float_bits(x); }

static bool none(scree_body body) { return (body.index | body.generation) == 0; }

static scree_status check_ignored(const scree_world* world, Where at, scree_body ignored)
{
	int index;
	return none(ignored) ? SCREE_OK : check_body(world, at, ".ignored", ignored, &index);
}

scree_status query_check_rays(scree_world* world, const char* function, const scree_ray* rays, Questions* questions)
{
	const uint32_t all = ~0u, low = bits_of(SCREE_HUGE), high = bits_of(2.0f * SCREE_HUGE);
	const Plain plain = {{{MAGNITUDE, MAGNITUDE, MAGNITUDE, MAGNITUDE}, {all, all, all, all}},
	                     {{low, low, high, high}, {low, 0, 0, 0}}};
	questions->form = QUERY_RAYS;
	for (int k = plain_items(rays, questions->count, &plain); k < questions->count; ++k)
	{
		const scree_ray* ray = rays + k;
		Where at = {function, "rays", k};
		TRY(check_vec(at, ".origin", ray->origin, SCREE_HUGE));
		TRY(check_vec(at, ".translation", ray->translation, 2.0f * SCREE_HUGE));
		TRY(check_real(at, ".radius", ray->radius, 0.0f, SCREE_HUGE));
		if (ray->reserved != 0)
			return refuse(SCREE_ERROR_INVALID, at, ".reserved", "is %u, must be 0", ray->reserved);
		TRY(check_ignored(world, at, ray->ignored));
	}
	return SCREE_OK;
}

scree_status query_shape_of(const char* function, const char* argument, const scree_shape* given, Attribute* to)
{
	*to = (Attribute){.count = 1};
	if (!given)
		return SCREE_OK;
	scree_shape shape = *given;
	TRY(shape_finish((Where){function, argument, ALONE}, &shape));
	to->count = shape.count;
	to->radius = shape.radius;
	for (int k = 0; k < shape.count; ++k)
	{
		to->vertices[k] = make_float2(shape.vertices[k].x, shape.vertices[k].y);
		to->normals[k] = make_float2(shape.normals[k].x, shape.normals[k].y);
	}
	return SCREE_OK;
}

// The same; the shape of the last query is known, and need not be checked again.
static scree_status set_shape(scree_world* world, const char* function, const scree_shape* shape, Attribute* to)
{
	Queries* known = &world->queries;
	if (!shape)
		return query_shape_of(function, "shape", NULL, to);
	if (known->attribute.count == 0 || memcmp(shape, &known->shape, sizeof *shape) != 0)
	{
		Attribute made;
		TRY(query_shape_of(function, "shape", shape, &made));
		known->shape = *shape;
		known->attribute = made;
	}
	*to = known->attribute;
	return SCREE_OK;
}

// Whether a rotation has a length of 1, as far as check_pose wants it.
static bool is_turn(scree_rot r)
{
	float square = r.c * r.c + r.s * r.s;
	return square > 0.9995f && square < 1.0005f;
}

scree_status query_check_probes(scree_world* world, const char* function, const scree_shape* shape,
                                const scree_probe* probes, bool moves, Questions* questions)
{
	questions->form = QUERY_SHAPES;
	TRY(set_shape(world, function, shape, &questions->plan.shape));
	float most = moves ? 2.0f * SCREE_HUGE : 0.0f;
	const uint32_t low = bits_of(SCREE_HUGE), one = bits_of(2.0f), high = bits_of(most);
	const Plain plain = {{{MAGNITUDE, MAGNITUDE, MAGNITUDE, MAGNITUDE}, {MAGNITUDE, MAGNITUDE, ~0u, ~0u}},
	                     {{low, low, one, one}, {high, high, 0, 0}}};
	int plain_count = plain_items(probes, questions->count, &plain);
	for (int k = 0; k < questions->count; ++k)
	{
		const scree_probe* probe = probes + k;
		Where at = {function, "probes", k};
		scree_pose pose = probe->pose;
		if (k < plain_count && is_turn(pose.rotation))
			continue;
		TRY(check_pose(at, ".pose", &pose));
		TRY(check_vec(at, ".translation", probe->translation, most));
		TRY(check_ignored(world, at, probe->ignored));
	}
	return SCREE_OK;
}

static scree_status answer(scree_world* world, const char* function, const Questions* questions, scree_found* found)
{
	TRY(check_batch(function, "found", found, questions->count));
	if (questions->count == 0)
		return SCREE_OK;
	TRY(world_upload(world));
	double begin = auto_clock();
	scree_status status = queries_answer(&world->pipeline, questions, (Found*)(void*)found);
	auto_count(world, begin);
	return world_note(world, status);
}

scree_status scree_world_cast_rays(scree_world* world, const scree_query_def* def, const scree_ray* rays, int count,
                                   scree_found* found)
{
	const char* function = "scree_world_cast_rays";
	Questions questions;
	TRY(query_check(world, function, def, rays, "rays", count, &questions));
	TRY(query_check_rays(world, function, rays, &questions));
	return answer(world, function, &questions, found);
}

scree_status scree_world_cast_ray(scree_world* world, scree_vec origin, scree_vec translation, scree_found* found)
{
	const char* function = "scree_world_cast_ray";
	scree_ray ray = {.origin = origin, .translation = translation};
	Questions questions;
	TRY(query_check(world, function, NULL, &ray, "ray", 1, &questions));
	TRY(query_check_rays(world, function, &ray, &questions));
	return answer(world, function, &questions, found);
}

scree_status scree_world_cast_shapes(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                     const scree_probe* probes, int count, scree_found* found)
{
	const char* function = "scree_world_cast_shapes";
	Questions questions;
	TRY(query_check(world, function, def, probes, "probes", count, &questions));
	TRY(query_check_probes(world, function, shape, probes, true, &questions));
	return answer(world, function, &questions, found);
}

scree_status scree_world_cast_shape(scree_world* world, const scree_shape* shape, scree_pose pose,
                                    scree_vec translation, scree_found* found)
{
	const char* function = "scree_world_cast_shape";
	scree_probe probe = {.pose = pose, .translation = translation};
	Questions questions;
	TRY(query_check(world, function, NULL, &probe, "probe", 1, &questions));
	TRY(query_check_probes(world, function, shape, &probe, true, &questions));
	return answer(world, function, &questions, found);
}

scree_status scree_world_find_nearest(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                      const scree_probe* probes, int count, float distance, scree_found* found)
{
	const char* function = "scree_world_find_nearest";
	Questions questions;
	TRY(query_check(world, function, def, probes, "probes", count, &questions));
	if (questions.any)
		return fail(SCREE_ERROR_INVALID, "%s: def.any is true, but the nearest cannot be any", function);
	TRY(check_real((Where){function, "distance", ALONE}, "", distance, 0.0f, FLT_MAX));
	TRY(query_check_probes(world, function, shape, probes, false, &questions));
	questions.form = QUERY_NEAREST;
	// no two points of a world are farther apart, and the square has to be finite
	questions.plan.most = distance < 4.0f * SCREE_HUGE ? distance : 4.0f * SCREE_HUGE;
	return answer(world, function, &questions, found);
}
