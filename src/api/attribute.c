// SPDX-License-Identifier: MIT
// attribute.c -- attributes: made once for equal values, then shared by index.
#include "world/definition.h"
#include "world/geometry.h"
#include "world/world.h"
#include <string.h>

// A mass must have a finite inverse and sums of masses must be finite, over all sizes and numbers of shapes.
#define LEAST_DENSITY 1e-6f // kg/m^2
#define MOST_DENSITY  1e9f

// square roots, products and ratios of two stay finite
#define MOST_SURFACE 1e6f

// An enlarged box exceeds the tight one by an eighth of the shape: larger finds more pairs in vain, smaller is left more
// often. Metres.
#define LEAST_MARGIN 0.01f
#define MOST_MARGIN  0.1f

void scree_attribute_def_default_sized(scree_attribute_def* def, size_t size)
{
	scree_attribute_def made = {.size = (uint32_t)size, .density = 1.0f, .friction = 0.6f};
	scree_shape_make_box(0.5f, 0.5f, &made.shape);
	write_result(def, size, &made, sizeof made);
}

// A hash of all bytes (FNV-1a: Fowler, Noll, Vo, 1991) that is never 0.
static uint32_t name_of(const scree_attribute_def* def)
{
	uint32_t hash = 2166136261u;
	const unsigned char* bytes = (const unsigned char*)def;
	for (size_t i = 0; i < sizeof *def; ++i)
		hash = (hash ^ bytes[i]) * 16777619u;
	return hash ? hash : 1;
}

// Checks a definition and makes it canonical: equal values, equal bytes.
static scree_status check_def(const char* function, scree_attribute_def* def)
{
	Where at = {function, "def", ALONE};
	TRY(shape_finish((Where){function, "def.shape", ALONE}, &def->shape));
	if (def->density != 0.0f)
		TRY(check_real(at, ".density (when it is not 0)", def->density, LEAST_DENSITY, MOST_DENSITY));
	TRY(check_real(at, ".friction", def->friction, 0.0f, MOST_SURFACE));
	TRY(check_real(at, ".restitution", def->restitution, 0.0f, 1.0f));
	TRY(check_real(at, ".rolling_resistance", def->rolling_resistance, 0.0f, MOST_SURFACE));
	TRY(check_real(at, ".tangent_speed", def->tangent_speed, -SCREE_HUGE, SCREE_HUGE));

	// adding zero makes a negative zero positive
	scree_attribute_def plain;
	memset(&plain, 0, sizeof plain);
	plain.shape = def->shape;
	plain.density = def->density + 0.0f;
	plain.friction = def->friction + 0.0f;
	plain.restitution = def->restitution + 0.0f;
	plain.rolling_resistance = def->rolling_resistance + 0.0f;
	plain.tangent_speed = def->tangent_speed + 0.0f;
	plain.size = sizeof plain;
	*def = plain;
	return SCREE_OK;
}

// The entry of the table that holds a name and these values, or the empty one where it belongs.
static int* find(const scree_world* world, uint32_t name, const scree_attribute_def* def)
{
	uint32_t mask = (uint32_t)world->attribute_table_size - 1;
	for (uint32_t i = name & mask;; i = (i + 1) & mask)
	{
		int* entry = world->attribute_table + i;
		if (*entry == 0 || (world->attribute_names[*entry - 1] == name &&
		                    memcmp(world->attributes + *entry - 1, def, sizeof *def) == 0))
			return entry;
	}
}

// Room for one more attribute, in a table that is at most half full.
static scree_status reserve(scree_world* world, const char* function)
{
	int count = world->attribute_count, name_capacity = world->attribute_capacity;
	if (count >= MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: a world holds at most %d attributes", function, MAX_ITEMS);
	TRY(GROW(function, world->attribute_names, name_capacity, count + 1));
	TRY(GROW(function, world->attributes, world->attribute_capacity, count + 1));
	if (2 * (count + 1) <= world->attribute_table_size)
		return SCREE_OK;

	int size = world->attribute_table_size > 0 ? 2 * world->attribute_table_size : 64;
	int* table = scree_allocate((size_t)size * sizeof *table);
	if (!table)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a table of %d attributes", function, size / 2);
	scree_release(world->attribute_table);
	world->attribute_table = table;
	world->attribute_table_size = size;
	for (int k = 0; k < count; ++k)
		*find(world, world->attribute_names[k], world->attributes + k) = k + 1;
	return SCREE_OK;
}

scree_status scree_attribute_create(scree_world* world, const scree_attribute_def* def, scree_attribute* attribute)
{
	const char* function = "scree_attribute_create";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "def", def));
	TRY(check_pointer(function, "attribute", attribute));
	TRY(check_definition((Where){function, "def", ALONE}, def, 0, &attribute_definition));
	scree_attribute_def local;
	scree_attribute_def plain = *(const scree_attribute_def*)definition_at(def, 0, &attribute_definition, &local);
	TRY(check_def(function, &plain));
	TRY(reserve(world, function));

	uint32_t name = name_of(&plain);
	int* entry = find(world, name, &plain);
	if (*entry == 0)
	{
		int index = world->attribute_count++;
		world->attributes[index] = plain;
		world->attribute_names[index] = name;
		*entry = index + 1;
		if (plain.restitution != 0.0f || plain.rolling_resistance != 0.0f || plain.tangent_speed != 0.0f)
			world->pipeline.extras = true;
		if (plain.restitution != 0.0f)
			world->pipeline.bounces = true;
		if (plain.shape.radius != 0.0f)
			world->pipeline.round = true;
	}
	*attribute = attribute_handle(world, *entry - 1);
	return SCREE_OK;
}

scree_status scree_attribute_get_def_sized(const scree_world* world, scree_attribute attribute,
                                           scree_attribute_def* def, size_t size)
{
	const char* function = "scree_attribute_get_def";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "def", def));
	int index = 0;
	TRY(check_attribute(world, (Where){function, "attribute", ALONE}, "", attribute, &index));
	scree_attribute_def known = world->attributes[index];
	known.size = (uint32_t)size;
	write_result(def, size, &known, sizeof known);
	return SCREE_OK;
}

// The name is the generation, so that a handle of another world is only taken when it means the same.
scree_attribute attribute_handle(const scree_world* world, int index)
{
	return (scree_attribute){(uint32_t)index, world->attribute_names[index]};
}

scree_status check_attribute(const scree_world* world, Where at, const char* member, scree_attribute attribute,
                             int* index)
{
	if (scree_attribute_is_null(attribute))
		return refuse(SCREE_ERROR_STALE, at, member, "is null");
	if (attribute.index >= (uint32_t)world->attribute_count ||
	    world->attribute_names[attribute.index] != attribute.generation)
		return refuse(SCREE_ERROR_STALE, at, member, "(index %u) is no attribute of this world", attribute.index);
	*index = (int)attribute.index;
	return SCREE_OK;
}

void attribute_item(const scree_world* world, int index, Attribute* item)
{
	const scree_attribute_def* def = world->attributes + index;
	const scree_shape* shape = &def->shape;
	*item = (Attribute){.radius = shape->radius,
	                    .count = shape->count,
	                    .friction = def->friction,
	                    .restitution = def->restitution,
	                    .rolling_resistance = def->rolling_resistance,
	                    .tangent_speed = 0.0f - def->tangent_speed};
	scree_vec lower = shape->vertices[0], upper = lower;
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k], n = shape->normals[k];
		item->vertices[k] = make_float2(v.x, v.y);
		item->normals[k] = make_float2(n.x, n.y);
		lower = (scree_vec){v.x < lower.x ? v.x : lower.x, v.y < lower.y ? v.y : lower.y};
		upper = (scree_vec){v.x > upper.x ? v.x : upper.x, v.y > upper.y ? v.y : upper.y};
	}
	float width = upper.x - lower.x, height = upper.y - lower.y;
	float margin = 0.125f * ((width > height ? width : height) + 2.0f * shape->radius);
	margin = margin < MOST_MARGIN ? margin : MOST_MARGIN;
	item->margin = margin > LEAST_MARGIN ? margin : LEAST_MARGIN;
	item->reach = shape->reach;
}

float attribute_thickness(const scree_world* world, int index)
{
	const scree_shape* shape = &world->attributes[index].shape;
	float least = shape->count < 3 ? 0.0f : shape->reach;
	for (int k = 0; shape->count > 2 && k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k], n = shape->normals[k], c = shape->centroid;
		float side = (v.x - c.x) * n.x + (v.y - c.y) * n.y;
		least = side < least ? side : least;
	}
	return least + shape->radius;
}
