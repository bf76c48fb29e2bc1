// SPDX-License-Identifier: MIT
// touched.c -- ends the rest of groups of items that the user changes, in a world that sleeps. A command for a body may
// also change its collidables, whose groups the host adds.
#include "world/device/touched.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "world/memory.h"
#include "world/world.h"

// Adds a group, unless it was the last one of its kind that was added.
static scree_status add(scree_world* world, int kind, int item)
{
	Touched* t = &world->touched;
	int group = item / GROUP_ITEMS;
	if (t->last[kind] == 1 + group)
		return SCREE_OK;
	TRY(GROW("scree_world_step", t->keys, t->capacity, t->count + 1));
	t->keys[t->count++] = (Word64)kind << 32 | (Word64)group;
	t->last[kind] = 1 + group;
	return SCREE_OK;
}

// Adds a collidable that the user changes or destroys, and its group.
static scree_status add_collidable(scree_world* world, int index)
{
	Touched* t = &world->touched;
	TRY(add(world, GROUPS_OF_COLLIDABLES, index));
	if (index >= world->pipeline.collidables) // it is new, and its slot had no other collidable
		return SCREE_OK;
	TRY(GROW("scree_world_step", t->keys, t->capacity, t->count + 1));
	t->keys[t->count++] = (Word64)GROUP_KINDS << 32 | (Word64)index;
	return SCREE_OK;
}

static scree_status add_body(scree_world* world, int index)
{
	TRY(add(world, GROUPS_OF_BODIES, index));
	for (int k = world->host_bodies[index].first_collidable; k >= 0; k = world->host_collidables[k].next)
		TRY(add(world, GROUPS_OF_COLLIDABLES, k));
	return SCREE_OK;
}

scree_status touched_collect(scree_world* world)
{
	const Edits* p = &world->edits;
	Touched* t = &world->touched;
	t->count = 0;
	for (int kind = 0; kind < GROUP_KINDS; ++kind)
		t->last[kind] = 0;
	if (!world->pipeline.listed) // the next step, if the world then sleeps, makes all groups active
		return SCREE_OK;
	for (int k = 0; k < p->body_count; ++k)
		TRY(add_body(world, p->bodies[k].index));
	for (int k = 0; k < p->collidable_count; ++k)
		TRY(add_collidable(world, p->collidables[k].index));
	for (int k = 0; k < p->command_count; ++k)
		TRY(p->commands[k].kind < COMMAND_PLACE ? add_body(world, p->commands[k].index)
		                                        : add_collidable(world, p->commands[k].index));
	return pipeline_reserve(&world->pipeline, PER_KEY, t->count);
}

scree_status touched_upload(scree_world* world)
{
	Touched* t = &world->touched;
	Backend* b = world->backend;
	Step step = {0};
	Run run = {.kernel_id = KERNEL_group_touch, .end = t->count, .count = NO_COUNT};
	if (t->count == 0)
		return SCREE_OK;
	TRY(b->f->write(b, POOL_key, 0, t->count, t->keys));
	return b->f->run(b, &step, &run, 1);
}
