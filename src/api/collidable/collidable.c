// SPDX-License-Identifier: MIT
// collidable.c -- creates, destroys and lists collidables.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/collidables.h"
#include "world/objects/handles.h"
#include "world/objects/mass.h"
#include "world/objects/own_shapes.h"
#include "world/record/api_calls.h"

scree_filter scree_filter_default(void) { return (scree_filter){.category = 1, .mask = UINT64_MAX}; }

void scree_collidable_def_default_sized(scree_collidable_def* def, size_t size)
{
	const scree_collidable_def made = {
	    .size = (uint32_t)size, .pose.rotation.c = 1.0f, .filter = scree_filter_default()};
	write_result(def, size, &made, sizeof made);
}

bool scree_collidable_is_valid(const scree_world* world, scree_collidable collidable)
{
	return world && collidable_is_valid(world, collidable);
}

typedef struct // arguments of a call that creates collidables
{
	const char* function;
	const char *argument, *shape_argument; // names of the arguments
	const scree_collidable_def* defs;
	const scree_attribute_def* shapes; // null: collidables have the attributes of their definitions
	int count;
	scree_collidable* collidables; // may be null
	bool alone;                    // true: the arguments are not arrays
} Creation;

static scree_status check_def(const scree_world* world, const Creation* c, int k, HostCollidable* made)
{
	scree_collidable_def local;
	ArgumentPlace at = {c->function, c->argument, c->alone ? ALONE : k};
	TRY(check_definition(at, c->defs, k, &collidable_definition));
	const scree_collidable_def* def = definition_at(c->defs, k, &collidable_definition, &local);
	*made = (HostCollidable){.body = -1,
	                         .pose = def->pose,
	                         .filter = def->filter,
	                         .reports = def->reports,
	                         .sensor = def->sensor,
	                         .user = def->user};
	if (!c->shapes)
		TRY(check_attribute(world, at, ".attribute", def->attribute, &made->attribute));
	else if (!scree_attribute_is_null(def->attribute))
		return refuse(SCREE_ERROR_INVALID, at, ".attribute", "is (%u, %u), must be null: the call has a shape",
		              def->attribute.index, def->attribute.generation);
	TRY(check_reports(at, ".reports", def->reports));
	TRY(check_sensor(at, ".sensor", def->sensor));
	if (!scree_body_is_null(def->body))
		TRY(check_body(world, at, ".body", def->body, &made->body));
	return check_pose(at, ".pose", &made->pose);
}

static scree_status create(scree_world* world, Creation c)
{
	TRY(world_check(world, c.function));
	TRY(check_batch(c.function, c.argument, c.defs, c.count));
	HostCollidable made;
	for (int k = 0; k < c.count; ++k)
		TRY(check_def(world, &c, k, &made));
	if (c.shapes)
		TRY(own_shapes_check(c.function, c.shape_argument, c.shapes, c.count, c.alone));
	TRY(collidables_reserve(world, c.function, c.count));
	TRY(edits_reserve(world, c.function, 0, c.count, c.count));
	int* slots = world_scratch(world, 3 * (size_t)c.count * sizeof *slots);
	if (!slots)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d collidables", c.function, c.count);
	int *bodies = slots + c.count, *attributes = bodies + c.count;
	for (int k = 0; k < c.count; ++k)
	{
		check_def(world, &c, k, &made);
		bodies[k] = made.body;
		slots[k] = kind_on_body(world, made.body);
		attributes[k] = made.attribute;
	}
	if (c.shapes)
		TRY(own_shapes_make(world, c.function, c.shapes, c.count, attributes));
	scree_status status = collidables_allocate(world, slots, c.count);
	if (status != SCREE_OK && c.shapes)
		own_shapes_settle(world, attributes, c.count);
	TRY(status);
	for (int k = 0; k < c.count; ++k)
	{
		check_def(world, &c, k, &made);
		made.attribute = attributes[k];
		collidable_put(world, slots[k], &made);
		if (c.collidables)
			c.collidables[k] = collidable_handle(world, slots[k]);
	}
	masses_update(world, bodies, c.count, true);
	return SCREE_OK;
}

scree_status api_collidables_create(scree_world* world, const scree_collidable_def* defs, int count,
                                    scree_collidable* collidables)
{
	FLOAT_MODE_HERE;
	return create(world, (Creation){"scree_collidables_create", "defs", NULL, defs, NULL, count, collidables, false});
}

scree_status api_collidable_create(scree_world* world, const scree_collidable_def* def, scree_collidable* collidable)
{
	FLOAT_MODE_HERE;
	return create(world, (Creation){"scree_collidable_create", "def", NULL, def, NULL, 1, collidable, true});
}

scree_status api_collidables_create_with_shapes(scree_world* world, const scree_collidable_def* defs,
                                                const scree_attribute_def* shapes, int count,
                                                scree_collidable* collidables)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidables_create_with_shapes";
	TRY(check_batch(function, "shapes", shapes, count));
	return create(world, (Creation){function, "defs", "shapes", defs, shapes, count, collidables, false});
}

scree_status api_collidable_create_with_shape(scree_world* world, const scree_collidable_def* def,
                                              const scree_attribute_def* shape, scree_collidable* collidable)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidable_create_with_shape";
	TRY(check_pointer(function, "shape", shape));
	return create(world, (Creation){function, "def", "shape", def, shape, 1, collidable, true});
}

static scree_status destroy(scree_world* world, const char* function, const char* argument,
                            const scree_collidable* collidables, int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, collidables, count));
	TRY(edits_reserve(world, function, 0, count, count));
	int* bodies = world_scratch(world, (size_t)count * sizeof *bodies);
	if (!bodies)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d collidables", function, count);
	scree_status status = SCREE_OK;
	int marked = 0;
	for (int index = 0; marked < count && status == SCREE_OK;)
	{
		ArgumentPlace at = {function, argument, alone ? ALONE : marked};
		status = check_collidable(world, at, collidables[marked], &index);
		if (status == SCREE_OK && world->host_collidables[index].marked)
			status = refuse(SCREE_ERROR_STALE, at, "", "is twice in the batch");
		if (status == SCREE_OK)
		{
			world->host_collidables[index].marked = true;
			bodies[marked++] = world->host_collidables[index].body;
		}
	}
	for (int k = 0; k < marked; ++k)
		world->host_collidables[collidables[k].index - 1].marked = false;
	TRY(status);
	for (int k = 0; k < count; ++k)
		collidable_remove(world, (int)collidables[k].index - 1);
	masses_update(world, bodies, count, false);
	return SCREE_OK;
}

scree_status api_collidables_destroy(scree_world* world, const scree_collidable* collidables, int count)
{
	FLOAT_MODE_HERE;
	return destroy(world, "scree_collidables_destroy", "collidables", collidables, count, false);
}

scree_status api_collidable_destroy(scree_world* world, scree_collidable collidable)
{
	FLOAT_MODE_HERE;
	return destroy(world, "scree_collidable_destroy", "collidable", &collidable, 1, true);
}

scree_status api_body_get_collidables(const scree_world* world, scree_body body, scree_collidable* collidables,
                                      int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_collidables";
	TRY(check_pointer(function, "world", world));
	TRY(check_list(function, "collidables", collidables, capacity, count));
	int listed = 0, index = 0;
	if (scree_body_is_null(body))
	{
		for (int k = 0; k < world->collidables.used; ++k)
		{
			if (!slots_in_use(&world->collidables, k) || world->host_collidables[k].body >= 0)
				continue;
			if (listed < capacity)
				collidables[listed] = collidable_handle(world, k);
			++listed;
		}
	}
	else
	{
		TRY(check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, &index));
		for (int k = world->host_bodies[index].first_collidable; k >= 0; k = world->host_collidables[k].next)
		{
			if (listed < capacity)
				collidables[listed] = collidable_handle(world, k);
			++listed;
		}
	}
	*count = listed;
	return SCREE_OK;
}
