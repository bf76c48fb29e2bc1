// SPDX-License-Identifier: MIT
// collidables.c -- keeps the slots of collidables, their lists by body, and their kinds.
#include "world/objects/collidables.h"
#include "platform/error.h"
#include "step/tree_maintenance.h"
#include "world/edits.h"
#include "world/memory.h"
#include "world/objects/attributes.h"
#include "world/objects/reports.h"
#include "world/objects/sensors.h"

int kind_of_type(scree_body_type type)
{
	return type == SCREE_BODY_STATIC ? KIND_STATIC : type == SCREE_BODY_KINEMATIC ? KIND_KINEMATIC : KIND_DYNAMIC;
}

int kind_on_body(const scree_world* world, int body)
{
	if (body < 0)
		return KIND_FREE;
	return world->host_bodies[body].disabled ? KIND_DEAD : kind_of_type(world->host_bodies[body].type);
}

int collidable_kind(const scree_world* world, int index)
{
	if (!slots_in_use(&world->collidables, index))
		return KIND_DEAD;
	return kind_on_body(world, world->host_collidables[index].body);
}

int device_kind(const scree_world* world, int index)
{
	int kind = collidable_kind(world, index);
	return kind != KIND_DEAD && world->host_collidables[index].sensor ? kind | KIND_SENSOR : kind;
}

scree_status collidables_reserve(scree_world* world, const char* function, int more)
{
	if (world->collidables.alive + more > MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: %d more collidables beside %d: a world holds at most %d", function, more,
		            world->collidables.alive, MAX_ITEMS);
	if (!slots_reserve(&world->collidables, more))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d more collidables", function, more);
	return GROW(function, world->host_collidables, world->host_collidable_capacity, world->collidables.capacity);
}

scree_status collidables_allocate(scree_world* world, int* slots, int count)
{
	int used = world->collidables.used;
	for (int k = 0; k < count; ++k)
	{
		int kind = slots[k];
		slots[k] = slots_allocate(&world->collidables);
		scree_status status =
		    kind == KIND_DEAD ? SCREE_OK : tree_insert(&world->pipeline, tree_of_kind(kind), slots[k]);
		if (status == SCREE_OK)
			continue;

		for (; k >= 0; --k)
		{
			tree_withdraw(&world->pipeline, slots[k]);
			slots_put_back(&world->collidables, slots[k], used);
		}
		return status;
	}
	return SCREE_OK;
}

scree_status collidable_mark_tree(scree_world* world, int index)
{
	int kind = collidable_kind(world, index);
	return kind == KIND_DEAD ? SCREE_OK : tree_insert(&world->pipeline, tree_of_kind(kind), index);
}

// Records a changed link from the collidable `previous` to the next one in its list, unless the whole row of `previous`
// is pending. Does nothing if `previous` is -1.
static void list_changed(scree_world* world, int previous)
{
	if (previous < 0 || world->host_collidables[previous].waiting.row > 0)
		return;
	int next = world->host_collidables[previous].next;
	edits_command(world, COMMAND_NEXT, previous, make_float4(0.0f, 0.0f, 0.0f, 0.0f), next + 1);
}

void collidable_put(scree_world* world, int index, const HostCollidable* made)
{
	HostCollidable* host = world->host_collidables + index;
	PendingEdits waiting = host->waiting;
	*host = *made;
	host->waiting = waiting;
	attribute_attach(world, host->attribute);
	world->reports.reporters += host->reports != 0;
	reports_note(world, host->reports);
	sensors_note(world, 0, host->sensor);
	host->made = host->born = world->pipeline.steps;
	host->next = host->previous = -1;
	if (host->body >= 0)
	{
		HostBody* body = world->host_bodies + host->body;
		host->previous = body->last_collidable;
		if (host->previous >= 0)
			world->host_collidables[host->previous].next = index;
		else
			body->first_collidable = index;
		body->last_collidable = index;
		++body->collidables;
		list_changed(world, host->previous);
	}
	edits_collidable(world, index);
}

void collidable_remove(scree_world* world, int index)
{
	HostCollidable* host = world->host_collidables + index;
	reports_depart(world, index);
	sensors_note(world, host->sensor, 0);
	if (host->body >= 0)
	{
		HostBody* body = world->host_bodies + host->body;
		if (host->previous >= 0)
			world->host_collidables[host->previous].next = host->next;
		else
			body->first_collidable = host->next;
		if (host->next >= 0)
			world->host_collidables[host->next].previous = host->previous;
		else
			body->last_collidable = host->previous;
		--body->collidables;
		world->pipeline.unlocked |= body->collidables == 0 && body->first_joint > 0;
		list_changed(world, host->previous);
	}
	int kind = collidable_kind(world, index);
	if (kind != KIND_DEAD)
		tree_leave(&world->pipeline, tree_of_kind(kind), index);
	attribute_detach(world, host->attribute);
	slots_free(&world->collidables, index);
	edits_collidable(world, index);
}
