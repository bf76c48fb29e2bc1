// SPDX-License-Identifier: MIT
// attribute.c -- attributes: made once for equal values, shared by index, and destroyed when nobody wants them.
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
		if (*entry == 0 || (world->host_attributes[*entry - 1].name == name &&
		                    memcmp(world->attributes + *entry - 1, def, sizeof *def) == 0))
			return entry;
	}
}

// Takes an entry out of the table. Those behind it that it kept from their places move up.
static void forget(scree_world* world, int* entry)
{
	int* table = world->attribute_table;
	uint32_t mask = (uint32_t)world->attribute_table_size - 1, hole = (uint32_t)(entry - table);
	for (uint32_t i = (hole + 1) & mask; table[i] != 0; i = (i + 1) & mask)
	{
		uint32_t home = world->host_attributes[table[i] - 1].name & mask;
		if (((i - home) & mask) < ((i - hole) & mask))
			continue;
		table[hole] = table[i];
		hole = i;
	}
	table[hole] = 0;
}

// Room for one more attribute, in a table that is at most half full.
static scree_status reserve(scree_world* world, const char* function)
{
	Slots* slots = &world->attribute_slots;
	Edits* p = &world->edits;
	if (slots->alive >= MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: a world holds at most %d attributes", function, MAX_ITEMS);
	if (!slots_reserve(slots, 1))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for one more attribute", function);
	TRY(GROW(function, world->attributes, world->attribute_capacity, slots->capacity));
	TRY(GROW(function, world->host_attributes, world->host_attribute_capacity, slots->capacity));
	TRY(GROW(function, p->attributes, p->attribute_capacity, p->attribute_count + 1));
	if (2 * (slots->alive + 1) <= world->attribute_table_size)
		return SCREE_OK;

	int size = world->attribute_table_size > 0 ? 2 * world->attribute_table_size : 64;
	int* table = scree_allocate((size_t)size * sizeof *table);
	if (!table)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a table of %d attributes", function, size / 2);
	scree_release(world->attribute_table);
	world->attribute_table = table;
	world->attribute_table_size = size;
	for (int k = 0; k < slots->used; ++k)
		if (slots_in_use(slots, k))
			*find(world, world->host_attributes[k].name, world->attributes + k) = k + 1;
	return SCREE_OK;
}

// A new attribute in a slot of its own; the device hears of it with the next batch.
static int make(scree_world* world, uint32_t name, const scree_attribute_def* plain)
{
	Edits* p = &world->edits;
	int index = slots_take(&world->attribute_slots);
	HostAttribute* host = world->host_attributes + index;
	if (!host->waiting)
		p->attributes[p->attribute_count++] = index;
	world->attributes[index] = *plain;
	*host = (HostAttribute){.name = name, .waiting = true};
	if (plain->restitution != 0.0f || plain->rolling_resistance != 0.0f || plain->tangent_speed != 0.0f)
		world->pipeline.rolls = true;
	if (plain->restitution != 0.0f)
		world->pipeline.bounces = true;
	if (plain->shape.radius != 0.0f)
		world->pipeline.round = true;
	return index;
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
		*entry = make(world, name, &plain) + 1;
	++world->host_attributes[*entry - 1].claims;
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

scree_status scree_attribute_destroy(scree_world* world, scree_attribute attribute)
{
	const char* function = "scree_attribute_destroy";
	TRY(world_check(world, function));
	int index = 0;
	Where at = {function, "attribute", ALONE};
	TRY(check_attribute(world, at, "", attribute, &index));
	HostAttribute* host = world->host_attributes + index;
	if (host->claims == 1 && host->collidables > 0)
		return refuse(SCREE_ERROR_INVALID, at, "", "(index %u) is still that of %d collidable%s", attribute.index,
		              host->collidables, host->collidables == 1 ? "" : "s");
	if (--host->claims > 0)
		return SCREE_OK;
	forget(world, find(world, host->name, world->attributes + index));
	slots_free(&world->attribute_slots, index);
	return SCREE_OK;
}

// The first attribute of a slot has its name for a generation, so that a handle of another world is only taken when it
// means the same. One that takes the slot later has another, even with the same values.
static uint32_t generation_of(const scree_world* world, int index)
{
	uint32_t before = world->attribute_slots.generation[index] >> 1;
	uint32_t generation = world->host_attributes[index].name ^ before * 0x9e3779b9u;
	return generation ? generation : 1;
}

scree_attribute attribute_handle(const scree_world* world, int index)
{
	return (scree_attribute){(uint32_t)index, generation_of(world, index)};
}

static bool is_valid(const scree_world* world, scree_attribute attribute)
{
	return attribute.index < (uint32_t)world->attribute_slots.used &&
	       slots_in_use(&world->attribute_slots, (int)attribute.index) &&
	       generation_of(world, (int)attribute.index) == attribute.generation;
}

bool scree_attribute_is_valid(const scree_world* world, scree_attribute attribute)
{
	return world && is_valid(world, attribute);
}

scree_status check_attribute(const scree_world* world, Where at, const char* member, scree_attribute attribute,
                             int* index)
{
	if (scree_attribute_is_null(attribute))
		return refuse(SCREE_ERROR_STALE, at, member, "is null");
	if (!is_valid(world, attribute))
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
