// SPDX-License-Identifier: MIT
// query_check.c -- checks queries: definition and shape before they start, rays and probes while the device works.
#include "api/query/query_check.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/pool_values.h"
#include "world/shape/geometry.h"
#include "world/upload/readers.h"
#include <stddef.h>
#include <string.h>

#define ALL_BITS (~(uint64_t)0)
#define ALL_KINDS \
	(SCREE_QUERY_STATIC | SCREE_QUERY_KINEMATIC | SCREE_QUERY_DYNAMIC | SCREE_QUERY_FREE | SCREE_QUERY_SENSORS)

void scree_query_def_default_sized(scree_query_def* def, size_t size)
{
	scree_query_def made = {.size = (uint32_t)size,
	                        .kinds = SCREE_QUERY_STATIC | SCREE_QUERY_KINEMATIC | SCREE_QUERY_DYNAMIC,
	                        .category = ALL_BITS,
	                        .mask = ALL_BITS};
	write_result(def, size, &made, sizeof made);
}

scree_status check_query_kinds(ArgumentPlace at, uint32_t kinds)
{
	return kinds & ~(uint32_t)ALL_KINDS
	           ? refuse(SCREE_ERROR_INVALID, at, ".kinds", "is %u, has bits other than SCREE_QUERY_*", kinds)
	           : SCREE_OK;
}

scree_status query_check(scree_world* world, const char* function, const scree_query_def* def, const void* items,
                         const char* items_name, int count, QueryItems* query_items, QueryRequest* questions)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, items_name, items, count));
	scree_query_def local;
	if (def)
	{
		ArgumentPlace at = {function, "def", ALONE};
		TRY(check_definition(at, def, 0, &query_definition));
		def = definition_at(def, 0, &query_definition, &local);
		TRY(check_query_kinds(at, def->kinds));
	}
	else
	{
		scree_query_def_default_sized(&local, sizeof local);
		def = &local;
	}
	*query_items = (QueryItems){world, function, items, 2.0f * SCREE_MAX_COORDINATE};
	*questions = (QueryRequest){.plan = {.category = def->category,
	                                     .mask = def->mask,
	                                     .kinds = def->kinds,
	                                     .skips = def->skip_inside,
	                                     .rules = def->one_way && world->pipeline.platforms,
	                                     .all = def->category == ALL_BITS && def->mask == ALL_BITS,
	                                     .shape = {.count = 1}},
	                            .any = def->any,
	                            .items = items,
	                            .count = count,
	                            .collidables = collidable_names(world),
	                            .bodies = body_names(world),
	                            .timings = world->def.timings};
	return SCREE_OK;
}

#define MAGNITUDE 0x7fffffffu
#define BLOCK     64 // number of items between two tests for items outside the bounds

typedef uint32_t Words4 __attribute__((vector_size(16))); // half of a ray or a probe

typedef struct // bounds of each word of an item. counts: mask of the compared bits; most: largest integer
{
	Words4 counts[2], most[2];
} PlainBits;

// Returns the number of leading items that are certainly within bounds. Sets *ignores to false only if all items are
// within bounds and no item ignores a body, whose handle is in its last two words. Words are compared as integers,
// because nonnegative floats are ordered like their bits, and NaN is above infinity. A word above its bound has a
// negative difference, with the highest bit set. Float comparisons took 6 ms for a million rays.
static int plain_items(const void* items, int count, const PlainBits* plain, bool* ignores)
{
	Words4 bodies = {0};
	int k = 0;
	for (; k < count; k += BLOCK)
	{
		Words4 odd = {0}, words[2];
		int end = count - k < BLOCK ? count : k + BLOCK;
		for (int i = k; i < end; ++i)
		{
			memcpy(words, (const char*)items + sizeof words * (size_t)i, sizeof words);
			bodies |= words[1];
			words[0] &= plain->counts[0];
			words[1] &= plain->counts[1];
			odd |= words[0] | (plain->most[0] - words[0]) | words[1] | (plain->most[1] - words[1]);
		}
		if ((odd[0] | odd[1] | odd[2] | odd[3]) >> 31)
			break;
	}
	*ignores = (bodies[2] | bodies[3]) != 0 || k < count;
	return k < count ? k : count;
}

static uint32_t bits_of(float x) { return (uint32_t)float_bits(x); }

// Checks the handles of ignored bodies in items begin to end - 1. Consecutive equal handles are checked once.
static scree_status check_ignored(const QueryItems* query_items, const char* name, size_t offset, int begin, int end)
{
	scree_body last = SCREE_NULL_BODY, body;
	for (int k = begin; k < end; ++k)
	{
		memcpy(&body, (const char*)query_items->items + sizeof(Query) * (size_t)k + offset, sizeof body);
		if (scree_body_equals(body, last) || scree_body_is_null(body))
			continue;
		TRY(check_body_once(query_items->world, (ArgumentPlace){query_items->function, name, k}, ".ignored", body));
		last = body;
	}
	return SCREE_OK;
}

static scree_status check_rays(const void* context, int begin, int end)
{
	const QueryItems* query_items = context;
	const scree_ray* rays = query_items->items;
	const uint32_t all = ~0u, low = bits_of(SCREE_MAX_COORDINATE), high = bits_of(2.0f * SCREE_MAX_COORDINATE);
	const PlainBits plain = {{{MAGNITUDE, MAGNITUDE, MAGNITUDE, MAGNITUDE}, {all, all, 0, 0}},
	                         {{low, low, high, high}, {low, 0, 0, 0}}};
	bool ignores;
	for (int k = begin + plain_items(rays + begin, end - begin, &plain, &ignores); k < end; ++k)
	{
		ArgumentPlace at = {query_items->function, "rays", k};
		TRY(check_vec(at, ".origin", rays[k].origin, SCREE_MAX_COORDINATE));
		TRY(check_vec(at, ".translation", rays[k].translation, 2.0f * SCREE_MAX_COORDINATE));
		TRY(check_real(at, ".radius", rays[k].radius, 0.0f, SCREE_MAX_COORDINATE));
		if (rays[k].reserved != 0)
			return refuse(SCREE_ERROR_INVALID, at, ".reserved", "is %u, must be 0", rays[k].reserved);
	}
	return ignores ? check_ignored(query_items, "rays", offsetof(scree_ray, ignored), begin, end) : SCREE_OK;
}

void query_rays(QueryItems* query_items, QueryRequest* questions)
{
	questions->form = QUERY_RAYS;
	questions->check = check_rays;
	questions->context = query_items;
}

scree_status query_shape_of(const char* function, const char* argument, const scree_shape* given, Attribute* to)
{
	*to = (Attribute){.count = 1};
	if (!given)
		return SCREE_OK;
	scree_shape shape = *given;
	TRY(shape_finish((ArgumentPlace){function, argument, ALONE}, &shape));
	shape_row(&shape, to);
	return SCREE_OK;
}

// Converts a shape as query_shape_of does. The world stores the result, in case the next query of this thread has the same
// shape.
static scree_status set_shape(scree_world* world, const char* function, const scree_shape* shape, Attribute* to)
{
	if (!shape)
		return query_shape_of(function, "shape", NULL, to);
	Queries* known = readers_queries(world, function);
	if (!known)
		return SCREE_ERROR_OUT_OF_MEMORY;
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

// Returns whether the length of a rotation is 1, to within the tolerance of check_pose.
static bool is_turn(scree_rot r)
{
	float square = r.c * r.c + r.s * r.s;
	return square > 0.9995f && square < 1.0005f;
}

static scree_status check_probes(const void* context, int begin, int end)
{
	const QueryItems* query_items = context;
	const scree_probe* probes = query_items->items;
	const uint32_t low = bits_of(SCREE_MAX_COORDINATE), one = bits_of(2.0f), high = bits_of(query_items->longest);
	const PlainBits plain = {{{MAGNITUDE, MAGNITUDE, MAGNITUDE, MAGNITUDE}, {MAGNITUDE, MAGNITUDE, 0, 0}},
	                         {{low, low, one, one}, {high, high, 0, 0}}};
	bool ignores;
	int plain_end = begin + plain_items(probes + begin, end - begin, &plain, &ignores);
	for (int k = begin; k < end; ++k)
	{
		scree_pose pose = probes[k].pose;
		ArgumentPlace at = {query_items->function, "probes", k};
		if (k < plain_end && is_turn(pose.rotation))
			continue;
		TRY(check_pose(at, ".pose", &pose));
		TRY(check_vec(at, ".translation", probes[k].translation, query_items->longest));
	}
	return ignores ? check_ignored(query_items, "probes", offsetof(scree_probe, ignored), begin, end) : SCREE_OK;
}

scree_status query_probes(scree_world* world, const scree_shape* shape, QueryItems* query_items,
                          QueryRequest* questions)
{
	questions->form = QUERY_SHAPES;
	questions->check = check_probes;
	questions->context = query_items;
	return set_shape(world, query_items->function, shape, &questions->plan.shape);
}
