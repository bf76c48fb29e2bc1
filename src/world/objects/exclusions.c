// SPDX-License-Identifier: MIT
// exclusions.c -- keeps the pairs of bodies that the user excluded from touching: slots, lists by body, and the upload.
#include "world/objects/exclusions.h"
#include "dialect/hash_word.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "world/memory.h"

scree_status exclusions_reserve(scree_world* world, const char* function, int more)
{
	Exclusions* e = &world->exclusions;
	if (e->slots.alive + more > MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: %d more pairs beside %d: a world holds at most %d", function, more,
		            e->slots.alive, MAX_ITEMS);
	if (!slots_reserve(&e->slots, more))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d more pairs", function, more);
	return GROW(function, e->rows, e->capacity, e->slots.capacity);
}

int exclusion_find(const scree_world* world, int a, int b)
{
	const HostBody* bodies = world->host_bodies;
	int from = bodies[a].exclusions < bodies[b].exclusions ? a : b, to = from == a ? b : a;
	for (int end = bodies[from].first_exclusion; end > 0; end = exclusion_next(world, end))
		if (exclusion_other(world, end) == to)
			return exclusion_of_end(end);
	return -1;
}

static void link_end(scree_world* world, int index, int side)
{
	HostExclusion* row = world->exclusions.rows + index;
	HostBody* body = world->host_bodies + row->bodies[side];
	int end = 2 * index + side + 1, first = body->first_exclusion;
	row->next[side] = first;
	row->previous[side] = 0;
	if (first > 0)
		world->exclusions.rows[exclusion_of_end(first)].previous[(first - 1) % 2] = end;
	body->first_exclusion = end;
	++body->exclusions;
}

static void unlink_end(scree_world* world, int index, int side)
{
	HostExclusion* rows = world->exclusions.rows;
	HostBody* body = world->host_bodies + rows[index].bodies[side];
	int next = rows[index].next[side], previous = rows[index].previous[side];
	if (previous > 0)
		rows[exclusion_of_end(previous)].next[(previous - 1) % 2] = next;
	else
		body->first_exclusion = next;
	if (next > 0)
		rows[exclusion_of_end(next)].previous[(next - 1) % 2] = previous;
	--body->exclusions;
}

static void forget(scree_world* world, int index)
{
	unlink_end(world, index, 0);
	unlink_end(world, index, 1);
	slots_free(&world->exclusions.slots, index);
	world->exclusions.waiting = true;
}

void exclusion_set(scree_world* world, int a, int b, bool excluded)
{
	Exclusions* e = &world->exclusions;
	int index = exclusion_find(world, a, b);
	if ((index >= 0) == excluded)
		return;
	if (!excluded)
	{
		forget(world, index);
		return;
	}
	index = slots_allocate(&e->slots);
	e->rows[index] = (HostExclusion){.bodies = {a, b}};
	link_end(world, index, 0);
	link_end(world, index, 1);
	e->waiting = true;
	world->pipeline.rules = true;
}

void body_exclusions_remove(scree_world* world, int body)
{
	while (world->host_bodies[body].first_exclusion > 0)
		forget(world, exclusion_of_end(world->host_bodies[body].first_exclusion));
}

static Word64 key_of(const HostExclusion* row)
{
	int a = row->bodies[0], b = row->bodies[1];
	return (Word64)(a < b ? a : b) << 32 | (Word64)(a < b ? b : a);
}

scree_status upload_exclusions(scree_world* world)
{
	Exclusions* e = &world->exclusions;
	Pipeline* pipeline = &world->pipeline;
	Backend* b = world->backend;
	if (!e->waiting)
		return SCREE_OK;
	// rows that are no longer in use are written as NO_PAIR
	int rows = e->slots.used > pipeline->excluded ? e->slots.used : pipeline->excluded;
	TRY(pipeline_reserve(pipeline, PER_EXCLUDED, rows));
	Word64* keys = world_scratch(world, (size_t)rows * sizeof *keys);
	if (!keys)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to upload %d pairs of bodies", rows);
	for (int k = 0; k < rows; ++k)
		keys[k] = k < e->slots.used && slots_in_use(&e->slots, k) ? key_of(e->rows + k) : NO_PAIR;
	TRY(b->f->write(b, POOL_excluded, 0, rows, keys));
	Step step = {0};
	Run run = {.kernel_id = KERNEL_excluded_changed, .end = 1, .count = NO_COUNT};
	TRY(b->f->run(b, &step, &run, 1));
	pipeline->excluded = rows;
	pipeline->dirty = true;
	e->waiting = false;
	return SCREE_OK;
}

uint64_t exclusions_hash(const scree_world* world)
{
	const Exclusions* e = &world->exclusions;
	Word64 sum = 0;
	for (int k = 0; k < e->slots.used; ++k)
		if (slots_in_use(&e->slots, k))
			sum += hash_mix(hash_begin(HASH_EXCLUDED, 0) + key_of(e->rows + k));
	return sum;
}

void exclusions_close(scree_world* world)
{
	slots_close(&world->exclusions.slots);
	scree_release(world->exclusions.rows);
}
