// SPDX-License-Identifier: MIT
// fields.c -- keeps the slots of fields, and uploads the active fields. Fields are few and rarely change, so after a
// change all active fields are uploaded, without gaps. Up to FIELD_FEW fields are in the order of their slots. More
// fields are sorted, so that boxes around several successive fields are small: first fields without a region, then
// fields in the world along a Morton curve (A Computer Oriented Geodetic Data Base, 1966), then fields on bodies. The
// order depends only on the user's calls.
#include "world/objects/fields.h"
#include "dialect/hash_word.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "world/memory.h"
#include "world/pool_values.h"
#include <stdlib.h>
#include <string.h>

scree_status fields_reserve(scree_world* world, const char* function)
{
	Fields* f = &world->fields;
	if (f->slots.alive >= MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: a world holds at most %d fields", function, MAX_ITEMS);
	if (!slots_reserve(&f->slots, 1))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for one more field", function);
	return GROW(function, f->host, f->capacity, f->slots.capacity);
}

int field_make(scree_world* world)
{
	int index = slots_allocate(&world->fields.slots);
	world->fields.host[index] = (HostField){.body = -1};
	return index;
}

static void count_on_body(scree_world* world, int body, int more)
{
	if (body >= 0)
		world->host_bodies[body].fields += more;
}

void field_put(scree_world* world, int index, const scree_field_def* def, int body)
{
	HostField* host = world->fields.host + index;
	count_on_body(world, host->body, -1);
	*host = (HostField){*def, body};
	count_on_body(world, body, 1);
	world->fields.stale = true;
}

void field_remove(scree_world* world, int index)
{
	count_on_body(world, world->fields.host[index].body, -1);
	slots_free(&world->fields.slots, index);
	world->fields.stale = true;
}

void fields_body_gone(scree_world* world, int body)
{
	Fields* f = &world->fields;
	for (int k = 0; k < f->slots.used && world->host_bodies[body].fields > 0; ++k)
		if (slots_in_use(&f->slots, k) && f->host[k].body == body)
			field_remove(world, k);
}

void fields_body_changed(scree_world* world, int body) { world->fields.stale |= world->host_bodies[body].fields > 0; }

static bool acts(const scree_world* world, int index)
{
	const HostField* host = world->fields.host + index;
	return slots_in_use(&world->fields.slots, index) && !host->def.disabled &&
	       (host->body < 0 || !world->host_bodies[host->body].disabled);
}

static Field field_row(const HostField* host)
{
	const scree_field_def* def = &host->def;
	const uint64_t all = ~(uint64_t)0;
	Field row;
	memset(&row, 0, sizeof row); // the padding is cleared, because the hash also reads it
	shape_row(&def->shape, &row.shape);
	row.pose = pose_row(def->pose);
	row.category = def->category;
	row.mask = def->mask;
	row.all = def->category == all && def->mask == all;
	row.body = host->body;
	row.kind = (int)def->type;
	row.falloff = (int)def->falloff;
	row.acceleration_x = def->acceleration.x;
	row.acceleration_y = def->acceleration.y;
	row.force_x = def->force.x;
	row.force_y = def->force.y;
	row.velocity_x = def->velocity.x;
	row.velocity_y = def->velocity.y;
	row.strength = def->strength;
	row.radius = def->radius;
	row.softening = def->softening;
	row.density = def->density;
	row.drag = def->drag;
	row.lift = def->lift;
	row.linear_drag = def->linear_drag;
	row.quadratic_drag = def->quadratic_drag;
	row.spin_drag = def->spin_drag;
	row.spin_drag_quadratic = def->spin_drag_quadratic;
	FLUSH_MEMBERS(&row, acceleration_x, spin_drag_quadratic);
	return row;
}

int fields_acting(const scree_world* world, bool* shapes)
{
	*shapes = world->fields.shapes;
	return world->fields.acting;
}

typedef struct // an active field with its sort key
{
	uint64_t key;
	int slot;
} ActiveField;

static uint64_t spread(uint32_t x)
{
	uint64_t bits = x;
	bits = (bits | bits << 16) & 0x0000ffff0000ffffu;
	bits = (bits | bits << 8) & 0x00ff00ff00ff00ffu;
	bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fu;
	bits = (bits | bits << 2) & 0x3333333333333333u;
	return (bits | bits << 1) & 0x5555555555555555u;
}

// Returns the distance of a coordinate from the lowest coordinate, as an integer of 30 bits in units of 0.2 mm.
static uint32_t fixed(float x) { return (uint32_t)(((double)x + (double)SCREE_MAX_COORDINATE) * 5000.0); }

static uint64_t key_of(const HostField* host)
{
	scree_vec at = host->def.pose.position;
	if (host->def.shape.count == 0)
		return 0;
	return host->body >= 0 ? UINT64_MAX : 1 + (spread(fixed(at.x)) | spread(fixed(at.y)) << 1);
}

static int compare(const void* a, const void* b)
{
	const ActiveField *x = a, *y = b;
	return x->key != y->key ? (x->key > y->key) - (x->key < y->key) : (x->slot > y->slot) - (x->slot < y->slot);
}

scree_status upload_fields(scree_world* world)
{
	Fields* f = &world->fields;
	Backend* b = world->backend;
	if (!f->stale)
		return SCREE_OK;
	int count = 0;
	bool shapes = false, carried = false;
	for (int k = 0; k < f->slots.used; ++k)
		count += acts(world, k);
	if (count > 0)
	{
		TRY(pipeline_reserve(&world->pipeline, PER_FIELD, count));
		TRY(pipeline_reserve(&world->pipeline, PER_FIELD_SPOT, (count + ARITY - 1) / ARITY * ARITY));
		Field* rows = world_scratch(world, (size_t)count * (sizeof *rows + sizeof(ActiveField)));
		if (!rows)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to upload %d fields", count);
		ActiveField* acting = (ActiveField*)(rows + count);
		for (int k = 0, row = 0; k < f->slots.used; ++k)
			if (acts(world, k))
				acting[row++] = (ActiveField){count > FIELD_FEW ? key_of(f->host + k) : 0, k};
		if (count > FIELD_FEW)
			qsort(acting, (size_t)count, sizeof *acting, compare);
		for (int row = 0; row < count; ++row)
		{
			const HostField* host = f->host + acting[row].slot;
			shapes |= host->def.type >= SCREE_FIELD_WIND;
			carried |= host->body >= 0;
			rows[row] = field_row(host);
		}
		TRY(b->f->write(b, POOL_field, 0, count, rows));
	}
	f->acting = count;
	f->shapes = shapes;
	f->carried = carried;
	f->stale = false;
	return SCREE_OK;
}

// Returns the number whose bytes in memory are the lower half of x, then the upper half, on every processor.
static Word64 low_first(Word64 x)
{
	Word halves[2] = {(Word)x, (Word)(x >> 32)};
	memcpy(&x, halves, sizeof x);
	return x;
}

uint64_t fields_hash(const scree_world* world)
{
	Word64 sum = 0;
	for (int k = 0; k < world->fields.slots.used; ++k)
	{
		if (!slots_in_use(&world->fields.slots, k))
			continue;
		Field row = field_row(world->fields.host + k);
		row.category = low_first(row.category);
		row.mask = low_first(row.mask);
		Word words[sizeof row / sizeof(Word)];
		memcpy(words, &row, sizeof row);
		Word64 h = hash_word(hash_begin(HASH_FIELD, k), world->fields.host[k].def.disabled);
		for (size_t i = 0; i < sizeof words / sizeof *words; ++i)
			h = hash_word(h, words[i]);
		sum += h;
	}
	return sum;
}

void fields_close(scree_world* world)
{
	slots_close(&world->fields.slots);
	scree_release(world->fields.host);
}
