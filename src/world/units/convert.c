// SPDX-License-Identifier: MIT
// convert.c -- converts the arguments and the results of a call between a world's unit of length and metres.
#include "world/units/convert.h"
#include "platform/processor.h"
#include "world/check.h"
#include "world/objects/handles.h"
#include <stddef.h>
#include <string.h>

static const void* pointer_at(const void* value)
{
	const void* pointer;
	memcpy(&pointer, value, sizeof pointer);
	return pointer;
}

static int argument_index(const UnitCall* call, const char* name)
{
	for (int k = 0; k < call->count; ++k)
		if (strcmp(call->arguments[k].name, name) == 0)
			return k;
	return -1;
}

static const scree_joint_def* joint_def_of(const scree_world* world, scree_joint joint)
{
	return joint_is_valid(world, joint) ? &world->host_joints[joint.index - 1].def : NULL;
}

// Returns the context of item k of an argument.
static UnitContext context_of(const Conversion* c, void* const* values, int k)
{
	const UnitCall* call = unit_calls + c->call;
	UnitContext context = {.nearest = c->call == UNITS_world_find_nearest};
	int which = argument_index(call, "which"), joint = argument_index(call, "joint"),
	    joints = argument_index(call, "joints");
	if (which >= 0)
		context.which = (int)*(const scree_coordinate*)values[which];
	if (joint >= 0)
		context.joint = joint_def_of(c->world, *(const scree_joint*)values[joint]);
	else if (joints >= 0 && pointer_at(values[joints]))
		context.joint = joint_def_of(c->world, ((const scree_joint*)pointer_at(values[joints]))[k]);
	return context;
}

// Converts the items of an argument.
static void items_scale(const Conversion* c, void* const* values, int argument, char* items, size_t bytes, int count,
                        Direction direction)
{
	const UnitArgument* row = unit_calls[c->call].arguments + argument;
	const UnitType* type = unit_types + row->type;
	bool plain = row->type == UNIT_float || row->type == UNIT_scree_vec;
	int power = plain ? unit_argument_power(c->call, row->name) : 0;
	for (int k = 0; k < count; ++k, items += bytes)
	{
		UnitContext context = context_of(c, values, k);
		scree_joint_def own = {0};
		if (row->type == UNIT_scree_joint_def)
		{
			memcpy(&own, items, bytes < sizeof own ? bytes : sizeof own);
			context.joint = &own;
		}
		if (plain)
			units_scale(c->unit, items, (int)(type->bytes / sizeof(float)), units_power(power, &context, items),
			            direction);
		else
			units_scale_by(c->unit, type, items, bytes, &context, direction);
	}
}

// ---------------------------------------------------------------------------------------------------------------
// arguments
// ---------------------------------------------------------------------------------------------------------------

static void* take(Conversion* c, size_t bytes)
{
	size_t padded = (bytes + 15) / 16 * 16;
	if (padded <= sizeof c->local - c->used)
	{
		c->used += padded;
		return c->local + c->used - padded;
	}
	void* block = scree_allocate(bytes);
	if (block)
		c->blocks[c->block_count++] = block;
	return block;
}

static void release(Conversion* c)
{
	for (int k = 0; k < c->block_count; ++k)
		scree_release(c->blocks[k]);
	c->block_count = 0;
}

// Returns the number of items of an array of arguments; 0 if the call will refuse it.
static int array_count(const UnitCall* call, void* const* values)
{
	for (int k = 0; k < call->count; ++k)
		if (call->arguments[k].kind == ARGUMENT_COUNT)
		{
			int count = *(const int*)values[k];
			return count < 0 || count > MAX_ITEMS ? 0 : count;
		}
	return 1;
}

// Returns the size of each item of an argument; 0 if the call will refuse it.
static size_t item_bytes(const UnitType* type, const char* items, int count)
{
	if (!type->sized)
		return type->bytes;
	uint32_t first = 0, size;
	for (int k = 0; k < count; ++k)
	{
		memcpy(&size, items + (size_t)k * first, sizeof size);
		first = k == 0 ? size : first;
		if (size != first || size < 2 * sizeof size || size > MOST_SIZE)
			return 0;
	}
	return first;
}

// Replaces the points of a path by a converted copy.
static bool points_in(Conversion* c, scree_path_def* path)
{
	if (!path->points || path->count < 2 || path->count > 65536)
		return true;
	size_t bytes = sizeof *path->points * (size_t)path->count;
	scree_vec* points = take(c, bytes);
	if (!points)
		return false;
	memcpy(points, path->points, bytes);
	units_scale(c->unit, (char*)points, 2 * path->count, 1, TO_METRES);
	path->points = points;
	return true;
}

// Converts an argument that is an address. Returns false if memory is missing.
static bool pointer_in(Conversion* c, void* const* values, int k)
{
	const UnitCall* call = unit_calls + c->call;
	ArgumentKind kind = call->arguments[k].kind;
	UnitTypeId id = call->arguments[k].type;
	const char* items = pointer_at(values[k]);
	int count = kind == ARGUMENT_ARRAY || kind == ARGUMENT_RESULTS ? array_count(call, values) : 1;
	size_t each = items ? item_bytes(unit_types + id, items, count) : 0, bytes = each * (size_t)count;
	if (bytes == 0)
		return true;
	bool result = kind == ARGUMENT_RESULT || kind == ARGUMENT_RESULTS;
	char* copy = take(c, result ? 2 * bytes : bytes);
	if (!copy)
		return false;
	memcpy(copy, items, bytes);
	items_scale(c, values, k, copy, each, count, TO_METRES);
	if (id == UNIT_scree_path_def && each >= offsetof(scree_path_def, closed) &&
	    !points_in(c, (scree_path_def*)(void*)copy))
		return false;
	if (id == UNIT_scree_draw_def && each >= offsetof(scree_draw_def, text) + sizeof(void*))
		units_draw(&c->pen, (scree_draw_def*)(void*)copy, c->unit);
	if (result)
	{
		c->given[k] = (char*)(uintptr_t)items;
		c->before[k] = memcpy(copy + bytes, copy, bytes);
	}
	memcpy(values[k], &copy, sizeof copy);
	return true;
}

scree_status units_in(Conversion* c, const scree_world* world, UnitCallId id, void* const* values)
{
	FLOAT_MODE_HERE;
	const UnitCall* call = unit_calls + id;
	memset(c, 0, offsetof(Conversion, local));
	c->world = world;
	c->unit = (double)world->def.length_unit;
	c->call = id;
	for (int k = 0; k < call->count; ++k)
	{
		ArgumentKind kind = call->arguments[k].kind;
		UnitTypeId type = call->arguments[k].type;
		bool both = type == UNIT_scree_mover || (type == UNIT_scree_joint_def && argument_index(call, "size") < 0);
		bool result = kind == ARGUMENT_RESULT || kind == ARGUMENT_RESULTS;
		if (type == UNIT_NONE || (result && !both))
			continue;
		if (kind == ARGUMENT_VALUE)
			items_scale(c, values, k, values[k], unit_types[type].bytes, 1, TO_METRES);
		else if (!pointer_in(c, values, k))
		{
			release(c);
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "scree_%s: no memory to convert %s to metres", call->name,
			            call->arguments[k].name);
		}
	}
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// results
// ---------------------------------------------------------------------------------------------------------------

// Converts the rows of a list that belongs to the world.
static void rows_out(const Conversion* c, UnitTypeId type, const void* rows, size_t bytes, int count)
{
	char* row = (char*)(uintptr_t)rows;
	for (int k = 0; k < count; ++k, row += bytes)
		units_scale_item(c->unit, type, row, bytes, TO_UNITS);
}

static void events_out(const Conversion* c, const scree_events* given)
{
	scree_events e = {0}; // members that the program lacks are 0
	memcpy(&e, given, given->size < sizeof e ? given->size : sizeof e);
	rows_out(c, UNIT_scree_contact, e.touches_began, e.contact_size, e.touches_began_count);
	rows_out(c, UNIT_scree_contact, e.touches_ended, e.contact_size, e.touches_ended_count);
	rows_out(c, UNIT_scree_contact, e.approvals, e.contact_size, e.approval_count);
	rows_out(c, UNIT_scree_hit, e.hits, e.hit_size, e.hit_count);
	rows_out(c, UNIT_scree_joint_event, e.joints, e.joint_size, e.joint_count);
}

// Writes a result that is also an argument back to the caller. Floats that the call did not change keep their bits.
static void given_out(const Conversion* c, void* const* values, int argument, int count)
{
	const UnitType* type = unit_types + unit_calls[c->call].arguments[argument].type;
	char *made = (char*)(uintptr_t)pointer_at(values[argument]), *given = c->given[argument];
	const char* before = c->before[argument];
	size_t each = item_bytes(type, given, count);
	char* after = made;
	for (int k = 0; k < count; ++k, after += each, before += each, given += each)
	{
		bool changed[MOST_SIZE / sizeof(float)] = {false};
		for (size_t at = 0; at + sizeof(float) <= each; at += sizeof(float))
			changed[at / sizeof(float)] = memcmp(after + at, before + at, sizeof(float)) != 0;
		items_scale(c, values, argument, after, each, 1, TO_UNITS);
		for (size_t at = 0; at + sizeof(float) <= each; at += sizeof(float))
			if (changed[at / sizeof(float)])
				memcpy(given + at, after + at, sizeof(float));
	}
}

static scree_status result_out(const Conversion* c, void* const* values, int k)
{
	const UnitCall* call = unit_calls + c->call;
	bool many = call->arguments[k].kind == ARGUMENT_RESULTS;
	UnitTypeId type = call->arguments[k].type;
	char* items = (char*)(uintptr_t)pointer_at(values[k]);
	int size = argument_index(call, "size"), capacity = argument_index(call, "capacity");
	size_t bytes = size >= 0 ? *(const size_t*)values[size] : unit_types[type].bytes;
	int count = many ? array_count(call, values) : 1;
	if (many && capacity >= 0)
	{
		int most = *(const int*)values[capacity],
		    found = *(const int*)pointer_at(values[argument_index(call, "count")]);
		count = most < found ? most : found;
	}
	if (!items)
		return SCREE_OK;
	if (c->given[k])
		given_out(c, values, k, count);
	else if (type == UNIT_scree_events)
		events_out(c, (const scree_events*)(void*)items);
	else if (type == UNIT_scree_moved_bodies)
	{
		const scree_moved_bodies* list = (const void*)items;
		rows_out(c, UNIT_scree_moved_body, list->bodies, list->body_size, list->count);
	}
	else if (type == UNIT_scree_query_results)
	{
		const scree_query_results* list = (const void*)items;
		rows_out(c, UNIT_scree_query_result, list->results, sizeof *list->results, list->count);
	}
	else
		items_scale(c, values, k, items, bytes, count, TO_UNITS);
	if (type != UNIT_scree_collidable_state)
		return SCREE_OK;
	scree_world* world = (scree_world*)(uintptr_t)c->world; // the call is one of a world that is not const
	return units_shapes(world, (scree_collidable_state*)(void*)items, bytes, count);
}

// Adds the unit of lengths to the message of a failure, if lengths can be in it.
static void explain(const Conversion* c, scree_status status)
{
	const UnitCall* call = unit_calls + c->call;
	bool lengths = status == SCREE_ERROR_CONTACT_LIMIT;
	for (int k = 0; k < call->count && status == SCREE_ERROR_INVALID; ++k)
		lengths |= call->arguments[k].type > UNIT_scree_vec ||
		           (call->arguments[k].type != UNIT_NONE && unit_argument_power(c->call, call->arguments[k].name) != 0);
	if (!lengths)
		return;
	Sentence kept = sentence_keep();
	fail(status, "%.800s; lengths in this sentence are in metres, and scree_world_def.length_unit is %s", kept.text,
	     decimal(c->world->def.length_unit).text);
}

scree_status units_out(Conversion* c, void* const* values, scree_status status)
{
	FLOAT_MODE_HERE;
	const UnitCall* call = unit_calls + c->call;
	for (int k = 0; k < call->count && status == SCREE_OK; ++k)
		if (call->arguments[k].type != UNIT_NONE &&
		    (call->arguments[k].kind == ARGUMENT_RESULT || call->arguments[k].kind == ARGUMENT_RESULTS))
			status = result_out(c, values, k);
	if (status != SCREE_OK)
		explain(c, status);
	release(c);
	return status;
}

void units_of_definition(scree_world_def* def)
{
	if (def->length_unit == 1.0f)
		def->length_unit = 0.0f;
	if (def->length_unit == 0.0f)
		return;
	units_scale_item((double)def->length_unit, UNIT_scree_world_def, def, sizeof *def, TO_METRES);
}
