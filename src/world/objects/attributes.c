// SPDX-License-Identifier: MIT
// attributes.c -- keeps the table of attributes, in which equal values share a slot, and ends attributes.
#include "world/objects/attributes.h"
#include "platform/error.h"
#include "world/memory.h"
#include "world/pool_values.h"
#include "world/structure.h"
#include "world/world.h"
#include <math.h>
#include <string.h>

// m: bounds of the margin of an enlarged box; between them, the margin is an eighth of the longer side of a box around
// the shape. A larger margin finds more pairs that do not touch; with a smaller one, bodies leave their boxes often.
#define LEAST_MARGIN 0.01f
#define MOST_MARGIN  0.1f

// Returns a hash of all bytes of a definition (FNV-1a: Fowler, Noll, Vo, 1991), never 0.
static uint32_t name_of(const scree_attribute_def* def)
{
	uint32_t hash = 2166136261u;
	const unsigned char* bytes = (const unsigned char*)def;
	for (size_t i = 0; i < sizeof *def; ++i)
		hash = (hash ^ bytes[i]) * 16777619u;
	return hash ? hash : 1;
}

// Returns the entry of an attribute in the table, or the empty entry to use for it. name: hash of its values. owned: the
// attribute has no claim. Attributes with and without claims never share a slot, so that neither keeps the other alive.
static int* find(const scree_world* world, uint32_t name, const scree_attribute_def* def, bool owned)
{
	uint32_t mask = (uint32_t)world->attribute_table_size - 1;
	for (uint32_t i = name & mask;; i = (i + 1) & mask)
	{
		int* entry = world->attribute_table + i;
		if (*entry == 0)
			return entry;
		const HostAttribute* host = world->host_attributes + *entry - 1;
		if (host->name == name && (host->claims == 0) == owned &&
		    memcmp(world->attributes + *entry - 1, def, sizeof *def) == 0)
			return entry;
	}
}

// Returns the entry of an existing attribute, or the empty entry to use for it.
static int* entry_of(const scree_world* world, int index)
{
	const HostAttribute* host = world->host_attributes + index;
	return find(world, host->name, world->attributes + index, host->claims == 0);
}

// Removes an entry from the table. Moves later entries into the gap if needed: a search ends at the first empty entry.
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

// Makes a table of `size` entries, a power of two above the number of attributes.
static scree_status table_make(scree_world* world, const char* function, int size)
{
	int* table = scree_allocate((size_t)size * sizeof *table);
	if (!table)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a table of %d attributes", function, size / 2);
	scree_release(world->attribute_table);
	world->attribute_table = table;
	world->attribute_table_size = size;
	for (int k = 0; k < world->attribute_slots.used; ++k)
		if (slots_in_use(&world->attribute_slots, k))
			*entry_of(world, k) = k + 1;
	return SCREE_OK;
}

// Reserves memory for one more attribute. The table is at most half full afterwards.
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

	return table_make(world, function, world->attribute_table_size > 0 ? 2 * world->attribute_table_size : 64);
}

scree_status attributes_restore(scree_world* world, const char* function)
{
	int size = 64;
	while (size < 2 * (world->attribute_slots.alive + 1))
		size *= 2;
	for (int k = 0; k < world->attribute_slots.used; ++k)
	{
		world->attributes[k].size = sizeof *world->attributes;
		world->host_attributes[k].name = name_of(world->attributes + k);
	}
	return table_make(world, function, size);
}

// Fills slot `index` of a new attribute.
static int make(scree_world* world, int index, uint32_t name, const scree_attribute_def* plain)
{
	Edits* p = &world->edits;
	HostAttribute* host = world->host_attributes + index;
	if (!host->waiting)
		p->attributes[p->attribute_count++] = index;
	world->attributes[index] = *plain;
	*host = (HostAttribute){.name = name, .waiting = true};
	if (plain->restitution != 0.0f || plain->rolling_resistance != 0.0f || plain->tangent_speed != 0.0f)
		world->pipeline.has_rolling = true;
	if (plain->tangent_speed != 0.0f)
		world->pipeline.belts = true;
	if (plain->shape.count == 2 && plain->shape.radius == 0.0f)
		world->pipeline.segments = true;
	if (plain->restitution != 0.0f)
		world->pipeline.bounces = true;
	if (plain->shape.radius != 0.0f)
		world->pipeline.round = true;
	if (plain->one_way.x != 0.0f || plain->one_way.y != 0.0f)
		world->pipeline.rules = world->pipeline.platforms = world->ruled = true;
	world->ruled |= plain->material != 0;
	return index;
}

// Finds the attribute with the values of `def`, or makes one with `claims` claims, 0 or 1.
static scree_status find_or_make(scree_world* world, const char* function, const scree_attribute_def* def, int claims,
                                 int* index)
{
	TRY(reserve(world, function));
	uint32_t name = name_of(def);
	int* entry = find(world, name, def, claims == 0);
	if (*entry == 0)
		*entry = make(world, slots_allocate(&world->attribute_slots), name, def) + 1;
	*index = *entry - 1;
	world->host_attributes[*index].claims += claims;
	structure_changed(world);
	return SCREE_OK;
}

scree_status attribute_claim(scree_world* world, const char* function, const scree_attribute_def* def, int* index)
{
	return find_or_make(world, function, def, 1, index);
}

scree_status attribute_own(scree_world* world, const char* function, const scree_attribute_def* def, int* index)
{
	return find_or_make(world, function, def, 0, index);
}

scree_status attribute_put(scree_world* world, const char* function, const scree_attribute_def* def, int index)
{
	Slots* slots = &world->attribute_slots;
	int more = index - slots->used > 0 ? index - slots->used + 1 : 1;
	if (!slots_reserve(slots, slots->free_count + more))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for attribute %d", function, index);
	TRY(reserve(world, function));
	int* passed = scree_allocate(sizeof *passed * (size_t)(index + 1));
	if (!passed)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for attribute %d", function, index);
	int count = 0, slot;
	while ((slot = slots_allocate(slots)) != index)
		passed[count++] = slot;
	uint32_t name = name_of(def);
	*find(world, name, def, true) = make(world, index, name, def) + 1;
	while (count > 0)
		slots_free(slots, passed[--count]);
	scree_release(passed);
	structure_changed(world);
	return SCREE_OK;
}

static void end(scree_world* world, int index)
{
	forget(world, entry_of(world, index));
	slots_free(&world->attribute_slots, index);
	structure_changed(world);
}

void attribute_disclaim(scree_world* world, int index)
{
	HostAttribute* host = world->host_attributes + index;
	structure_changed(world);
	if (host->claims == 1)
		end(world, index);
	--host->claims;
}

void attribute_attach(scree_world* world, int index) { ++world->host_attributes[index].collidables; }

void attribute_detach(scree_world* world, int index)
{
	--world->host_attributes[index].collidables;
	attribute_settle(world, index);
}

void attribute_settle(scree_world* world, int index)
{
	const HostAttribute* host = world->host_attributes + index;
	if (host->claims == 0 && host->collidables == 0 && slots_in_use(&world->attribute_slots, index))
		end(world, index);
}

void attribute_item(const scree_world* world, int index, Attribute* item)
{
	const scree_attribute_def* def = world->attributes + index;
	const scree_shape* shape = &def->shape;
	*item = (Attribute){.friction = def->friction,
	                    .restitution = def->restitution,
	                    .rolling_resistance = def->rolling_resistance,
	                    .tangent_speed = 0.0f - def->tangent_speed};
	flush_row(&item->friction, 4);
	shape_row(shape, item);
	scree_vec lower = shape->vertices[0], upper = lower;
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k];
		lower = (scree_vec){v.x < lower.x ? v.x : lower.x, v.y < lower.y ? v.y : lower.y};
		upper = (scree_vec){v.x > upper.x ? v.x : upper.x, v.y > upper.y ? v.y : upper.y};
	}
	float width = upper.x - lower.x, height = upper.y - lower.y;
	float margin = 0.125f * ((width > height ? width : height) + 2.0f * shape->radius);
	margin = margin < MOST_MARGIN ? margin : MOST_MARGIN;
	item->margin = margin > LEAST_MARGIN ? margin : LEAST_MARGIN;
	item->reach = shape->reach;
}

Rule attribute_rule(const scree_world* world, int index)
{
	scree_vec up = world->attributes[index].one_way;
	double length = sqrt((double)up.x * up.x + (double)up.y * up.y);
	Rule rule = {.material = world->attributes[index].material};
	if (length == 0.0)
		return rule;
	rule.one_way = 1;
	rule.up_x = (float)(up.x / length);
	rule.up_y = (float)(up.y / length);
	flush_row(&rule.up_x, 2);
	return rule;
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
