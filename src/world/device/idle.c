// SPDX-License-Identifier: MIT
// idle.c -- finds the blocks of bodies and of collidables that no step changes, so that a CPU can skip them.
#include "world/device/idle.h"
#include "world/memory.h"
#include "world/objects/collidables.h"
#include "world/world.h"

// states of a block; any other state is the number of steps until idle_end examines the block
#define IDLE  0
#define MOVES 255

// number of steps after an edit in which static items may change: one moves boxes, one clears the marks of moved boxes
#define SETTLING 2

static void touch(IdleBlocks* list, int index)
{
	int block = index / ACTIVE_ITEMS;
	if (block >= list->known) // a new block, which idle_begin adds
		return;
	list->states[block] = SETTLING;
	list->stale = list->settling = true;
}

static void touch_body(scree_world* world, int index)
{
	touch(&world->idle[ACTIVE_BODIES], index);
	for (int k = world->host_bodies[index].first_collidable; k >= 0; k = world->host_collidables[k].next)
		touch(&world->idle[ACTIVE_COLLIDABLES], k);
}

static bool is_idle(const IdleBlocks* list, int index)
{
	int block = index / ACTIVE_ITEMS;
	return block < list->known && list->states[block] == IDLE;
}

void idle_note(scree_world* world)
{
	if (!world->backend->skips)
		return;
	const Edits* p = &world->edits;
	for (int k = 0; k < p->body_count; ++k)
		touch_body(world, p->bodies[k].index);
	for (int k = 0; k < p->collidable_count; ++k)
		touch(&world->idle[ACTIVE_COLLIDABLES], p->collidables[k].index);
	for (int k = 0; k < p->command_count; ++k)
	{
		const Command* c = p->commands + k;
		if (c->kind >= COMMAND_PLACE)
			touch(&world->idle[ACTIVE_COLLIDABLES], c->index);
		else if (world->host_bodies[c->index].type == SCREE_BODY_STATIC ||
		         is_idle(&world->idle[ACTIVE_BODIES], c->index))
			touch_body(world, c->index);
	}
}

void idle_forget(scree_world* world)
{
	for (int k = 0; k < ACTIVE_KINDS; ++k)
		world->idle[k].known = 0;
}

static bool body_moves(const scree_world* world, int index)
{
	// body 0, the ground, counts as moving: item 0 of some kernels also does work that is needed once per step
	return index == 0 || (slots_in_use(&world->bodies, index) && world->host_bodies[index].type != SCREE_BODY_STATIC);
}

static bool collidable_moves(const scree_world* world, int index)
{
	int kind = collidable_kind(world, index);
	return kind != KIND_STATIC && kind != KIND_FREE && kind != KIND_DEAD;
}

static bool block_moves(const scree_world* world, int kind, int block)
{
	int used = kind == ACTIVE_BODIES ? world->bodies.used : world->collidables.used;
	for (int k = block * ACTIVE_ITEMS; k < (block + 1) * ACTIVE_ITEMS && k < used; ++k)
		if (kind == ACTIVE_BODIES ? body_moves(world, k) : collidable_moves(world, k))
			return true;
	return false;
}

static bool reserve(IdleBlocks* list, int blocks)
{
	if (GROW("scree_world_step", list->states, list->state_capacity, blocks) != SCREE_OK ||
	    GROW("scree_world_step", list->active, list->active_capacity, blocks) != SCREE_OK)
		return false;
	for (; list->known < blocks; ++list->known)
	{
		list->states[list->known] = SETTLING;
		list->stale = list->settling = true;
	}
	return true;
}

void idle_begin(scree_world* world)
{
	if (!world->backend->skips)
		return;
	for (int kind = 0; kind < ACTIVE_KINDS; ++kind)
	{
		IdleBlocks* list = &world->idle[kind];
		int used = kind == ACTIVE_BODIES ? world->bodies.used : world->collidables.used;
		world->backend->active[kind] = (ActiveBlocks){0};
		if (world->def.sleep || world->pipeline.sleeps) // the device lists the groups that a step visits
			continue;
		if (!reserve(list, (used + ACTIVE_ITEMS - 1) / ACTIVE_ITEMS))
			continue; // no memory for the list: no block is skipped
		if (list->stale)
		{
			list->count = 0;
			for (int block = 0; block < list->known; ++block)
				if (list->states[block] != IDLE)
					list->active[list->count++] = block;
		}
		list->stale = false;
		if (list->count < list->known)
			world->backend->active[kind] = (ActiveBlocks){list->active, list->count};
	}
}

void idle_end(scree_world* world)
{
	for (int kind = 0; kind < ACTIVE_KINDS; ++kind)
	{
		IdleBlocks* list = &world->idle[kind];
		if (!list->settling)
			continue;
		list->settling = false;
		for (int block = 0; block < list->known; ++block)
		{
			uint8_t* state = list->states + block;
			if (*state == IDLE || *state == MOVES)
				continue;
			*state = *state > 1 ? *state - 1 : block_moves(world, kind, block) ? MOVES : IDLE;
			list->stale |= *state == IDLE;
			list->settling |= *state == SETTLING - 1;
		}
	}
}

void idle_close(scree_world* world)
{
	for (int kind = 0; kind < ACTIVE_KINDS; ++kind)
	{
		scree_release(world->idle[kind].states);
		scree_release(world->idle[kind].active);
	}
}
