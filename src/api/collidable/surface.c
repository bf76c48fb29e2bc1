// SPDX-License-Identifier: MIT
// surface.c -- reads and replaces the attribute of a collidable, or the surface of its attribute.
#include "platform/processor.h"
#include "step/tree_maintenance.h"
#include "world/definition.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/attribute_check.h"
#include "world/objects/attributes.h"
#include "world/objects/collidables.h"
#include "world/objects/handles.h"
#include "world/objects/mass.h"
#include "world/objects/sleep.h"
#include "world/pool_values.h"
#include "world/record/api_calls.h"
#include <string.h>

void scree_surface_default_sized(scree_surface* surface, size_t size)
{
	const scree_surface made = {.size = (uint32_t)size, .friction = DEFAULT_FRICTION};
	write_result(surface, size, &made, sizeof made);
}

static scree_status lookup(const scree_world* world, const char* function, scree_collidable collidable,
                           const char* argument, const void* out, int* attribute)
{
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_collidable(world, (ArgumentPlace){function, "collidable", ALONE}, collidable, &index));
	*attribute = world->host_collidables[index].attribute;
	return check_pointer(function, argument, out);
}

scree_status api_collidable_get_attribute(const scree_world* world, scree_collidable collidable,
                                          scree_attribute* attribute)
{
	FLOAT_MODE_HERE;
	int index = 0;
	TRY(lookup(world, "scree_collidable_get_attribute", collidable, "attribute", attribute, &index));
	*attribute = attribute_handle(world, index);
	return SCREE_OK;
}

scree_status api_collidable_get_surface_sized(const scree_world* world, scree_collidable collidable,
                                              scree_surface* surface, size_t size)
{
	FLOAT_MODE_HERE;
	int index = 0;
	TRY(lookup(world, "scree_collidable_get_surface", collidable, "surface", surface, &index));
	const scree_attribute_def* def = world->attributes + index;
	const scree_surface known = {.size = (uint32_t)size,
	                             .friction = def->friction,
	                             .restitution = def->restitution,
	                             .rolling_resistance = def->rolling_resistance,
	                             .tangent_speed = def->tangent_speed};
	write_result(surface, size, &known, sizeof known);
	return SCREE_OK;
}

// Gives a collidable another attribute. If both have the same shape, memory was reserved before and the call cannot fail.
static scree_status change_attribute(scree_world* world, const char* function, int index, int now)
{
	HostCollidable* host = world->host_collidables + index;
	const scree_attribute_def *old = world->attributes + host->attribute, *def = world->attributes + now;
	TRY(edits_reserve(world, function, 0, 1, 2));
	body_note_wake(world, host->body);
	// the shapes of attributes are canonical: equal values have equal bytes
	bool same = memcmp(&old->shape, &def->shape, sizeof old->shape) == 0, heavier = old->density != def->density;
	if (!same)
		TRY(collidable_mark_tree(world, index));
	attribute_attach(world, now);
	attribute_detach(world, host->attribute);
	host->attribute = now;
	if (same)
	{
		edits_command(world, COMMAND_ATTRIBUTE, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), now);
		world->pipeline.surfaces_changed = true;
		if (collidable_kind(world, index) != KIND_DEAD)
			tree_forget(&world->pipeline, tree_of_kind(collidable_kind(world, index)));
	}
	else
	{
		host->born = world->pipeline.steps;
		edits_collidable(world, index);
	}
	if ((!same || heavier) && host->body >= 0)
		masses_update(world, &host->body, 1, false);
	return SCREE_OK;
}

scree_status api_collidable_set_attribute(scree_world* world, scree_collidable collidable, scree_attribute attribute)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidable_set_attribute";
	TRY(world_check(world, function));
	int index = 0, now = 0;
	TRY(check_collidable(world, (ArgumentPlace){function, "collidable", ALONE}, collidable, &index));
	TRY(check_attribute(world, (ArgumentPlace){function, "attribute", ALONE}, "", attribute, &now));
	if (world->host_collidables[index].attribute == now)
		return SCREE_OK;
	return change_attribute(world, function, index, now);
}

scree_status api_collidable_set_surface(scree_world* world, scree_collidable collidable, const scree_surface* surface)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidable_set_surface";
	ArgumentPlace at = {function, "surface", ALONE};
	TRY(world_check(world, function));
	int index = 0, now = 0;
	TRY(check_collidable(world, (ArgumentPlace){function, "collidable", ALONE}, collidable, &index));
	TRY(check_pointer(function, "surface", surface));
	TRY(check_definition(at, surface, 0, &surface_definition));
	scree_surface local;
	int old = world->host_collidables[index].attribute;
	scree_attribute_def def = world->attributes[old];
	TRY(surface_check(at, definition_at(surface, 0, &surface_definition, &local), &def));
	if (memcmp(&def, world->attributes + old, sizeof def) == 0)
		return SCREE_OK; // so that a call in each step keeps no body awake
	TRY(edits_reserve(world, function, 0, 1, 2));
	TRY(attribute_own(world, function, &def, &now));
	return change_attribute(world, function, index, now);
}
