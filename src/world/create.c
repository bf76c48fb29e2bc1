// SPDX-License-Identifier: MIT
// create.c -- creates a world on an open device, and destroys a world.
#include "world/create.h"
#include "platform/error.h"
#include "world/device/auto.h"
#include "world/device/idle.h"
#include "world/edits.h"
#include "world/memory.h"
#include "world/objects/exclusions.h"
#include "world/objects/fields.h"
#include "world/objects/materials.h"
#include "world/objects/paths.h"
#include "world/objects/reports.h"
#include "world/objects/sensors.h"
#include "world/upload/readers.h"
#include "world/world.h"
#include <stdio.h>

// Adds body 0, the ground, for joints and collidables without a body. Its slot is never in use: no handle refers to it.
static scree_status add_ground(scree_world* world, const char* function)
{
	if (!slots_reserve(&world->bodies, 1))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for bodies", function);
	TRY(GROW(function, world->host_bodies, world->host_body_capacity, world->bodies.capacity));
	TRY(edits_reserve(world, function, 1, 0, 0));
	world->bodies.used = 1;
	world->host_bodies[0] = (HostBody){.first_collidable = -1, .last_collidable = -1};
	edits_body(world, (BodyRow){.index = 0, .pose.rotation.c = 1.0f});
	return SCREE_OK;
}

void world_destroy(scree_world* world)
{
	auto_close(world);
	pipeline_close(&world->pipeline);
	if (world->backend)
		world->backend->f->close(world->backend);
	edits_close(&world->edits);
	slots_close(&world->bodies);
	slots_close(&world->collidables);
	slots_close(&world->attribute_slots);
	scree_release(world->host_bodies);
	scree_release(world->host_collidables);
	reports_close(world);
	materials_close(world);
	exclusions_close(world);
	sensors_close(world);
	scree_release(world->moved);
	for (int k = 0; k < world->unit_shapes.capacity; ++k)
		scree_release(world->unit_shapes.shapes[k]);
	scree_release(world->unit_shapes.shapes);
	scree_release(world->touched.keys);
	readers_close(world);
	scree_release(world->attributes);
	scree_release(world->host_attributes);
	scree_release(world->attribute_table);
	slots_close(&world->joints);
	scree_release(world->host_joints);
	paths_close(world);
	fields_close(world);
	scree_release(world->kinematics);
	scree_release(world->targets);
	idle_close(world);
	scree_release(world->scratch);
	scree_release(world->snapshot.bytes);
	scree_release(world);
	worlds_add(-1);
}

scree_status world_create(const scree_world_def* def, Backend* backend, scree_world** world)
{
	const char* function = "scree_world_create";
	*world = NULL;
	scree_world* made = scree_allocate(sizeof *made);
	if (!made)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a world", function);
	worlds_add(1);
	made->def = *def;
	// the pointers of the definition are valid only during the call
	made->def.device = made->device;
	if (def->opengl)
	{
		made->opengl = *def->opengl;
		made->def.opengl = &made->opengl;
	}
	if (def->tasks)
	{
		made->tasks = *def->tasks;
		made->def.tasks = &made->tasks;
	}
	snprintf(made->device, sizeof made->device, "%s", backend->name);
	made->backend = backend;
	scree_status status = pipeline_open(&made->pipeline, backend, def->body_capacity, def->contact_capacity);
	if (status == SCREE_OK)
		status = readers_open(made, function);
	if (status == SCREE_OK)
		status = add_ground(made, function);
	if (status == SCREE_OK)
		*world = made;
	else
	{
		made->backend = NULL;
		world_destroy(made);
	}
	return status;
}
