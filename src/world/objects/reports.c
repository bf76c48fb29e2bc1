// SPDX-License-Identifier: MIT
// reports.c -- keeps the number of reporting collidables, names of destroyed collidables, and events of the last step.
// Events identify collidables by slots. When events are read, a slot may have a new collidable: the old one was
// destroyed after the last step, or before that step, in which its contacts then ended. So each slot stores two names:
// that of the last collidable destroyed after an even number of steps, and that of the last one after an odd number.
// Before its first step a collidable has no events.
#include "world/objects/reports.h"
#include "dialect/hash_word.h"
#include "platform/error.h"
#include "step/event_readback.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include <string.h>

static CollidableName name_of(const scree_world* world, int index)
{
	return (CollidableName){.collidable = collidable_handle(world, index),
	                        .body = owner_handle(world, index),
	                        .user = world->host_collidables[index].user,
	                        .step = world->pipeline.steps};
}

scree_status reports_reserve(scree_world* world, const char* function)
{
	Reports* r = &world->reports;
	int old = r->departed_capacity, slots = 2 * world->collidables.capacity;
	if ((r->reporters == 0 && world->sensors.alive == 0 && old == 0) || slots <= old)
		return SCREE_OK;
	TRY(GROW(function, r->departed, r->departed_capacity, slots));
	for (int k = old; k < r->departed_capacity; ++k)
		r->departed[k] = (CollidableName){.step = -1};
	return SCREE_OK;
}

void reports_depart(scree_world* world, int index)
{
	Reports* r = &world->reports;
	const HostCollidable* host = world->host_collidables + index;
	int64_t steps = world->pipeline.steps;
	r->reporters -= host->reports != 0;
	if (r->departed_capacity == 0 || host->made >= steps)
		return;
	r->departed[2 * index + (steps & 1)] = name_of(world, index);
}

void reports_note(scree_world* world, uint32_t reports)
{
	if (reports & SCREE_REPORT_APPROVAL)
		world->pipeline.asks = world->pipeline.rules = true;
}

uint64_t allowed_hash(const scree_world* world)
{
	Word64 sum = 0;
	for (int k = 0; k < world->reports.allowed_count; ++k)
		sum += hash_mix(hash_begin(HASH_ALLOWED, 0) + world->reports.allowed[k]);
	return world->reports.answered ? sum + hash_mix(hash_begin(HASH_ALLOWED, 1)) : sum;
}

void reports_forget(scree_world* world)
{
	world->reports.fetched = world->reports.lost = true;
	memset(world->reports.counts, 0, sizeof world->reports.counts);
}

void reports_stepped(scree_world* world)
{
	world->reports.allowed_count = 0;
	world->reports.answered = world->reports.lost = false;
}

static scree_status fetch(scree_world* world)
{
	const char* function = "scree_world_get_events";
	Reports* r = &world->reports;
	Pipeline* pipeline = &world->pipeline;
	int counts[EVENT_LISTS];
	TRY(events_count(pipeline, counts));
	TRY(GROW(function, r->began, r->capacity[EVENT_TOUCH_BEGAN], counts[EVENT_TOUCH_BEGAN]));
	TRY(GROW(function, r->ended, r->capacity[EVENT_TOUCH_ENDED], counts[EVENT_TOUCH_ENDED]));
	TRY(GROW(function, r->hits, r->capacity[EVENT_HIT], counts[EVENT_HIT]));
	TRY(GROW(function, r->asked, r->capacity[EVENT_APPROVALS], counts[EVENT_APPROVALS]));
	if (counts[EVENT_APPROVALS] > 0)
		TRY(events_contacts(pipeline, EVENT_APPROVALS, counts[EVENT_APPROVALS], r->asked));
	if (counts[EVENT_TOUCH_BEGAN] > 0)
		TRY(events_contacts(pipeline, EVENT_TOUCH_BEGAN, counts[EVENT_TOUCH_BEGAN], r->began));
	if (counts[EVENT_TOUCH_ENDED] > 0)
		TRY(events_pairs(pipeline, counts[EVENT_TOUCH_ENDED], r->ended));
	if (counts[EVENT_HIT] > 0)
		TRY(events_contacts(pipeline, EVENT_HIT, counts[EVENT_HIT], r->hits));
	memcpy(r->counts, counts, sizeof counts);
	r->fetched = true;
	return SCREE_OK;
}

scree_status reports_fetch(scree_world* world)
{
	if (world->reports.fetched || !world->pipeline.reports || world->pipeline.steps == 0)
		return SCREE_OK;
	return world_note(world, fetch(world));
}

CollidableName reports_name(const scree_world* world, int index, bool before, int* destroyed)
{
	const CollidableName* names = world->reports.departed + 2 * index;
	int64_t steps = world->pipeline.steps;
	*destroyed = 1;
	if (before && names[(steps - 1) & 1].step == steps - 1)
		return names[(steps - 1) & 1];
	if (names[steps & 1].step == steps)
		return names[steps & 1];
	*destroyed = 0;
	return name_of(world, index);
}

void reports_close(scree_world* world)
{
	Reports* r = &world->reports;
	scree_release(r->departed);
	scree_release(r->began);
	scree_release(r->ended);
	scree_release(r->hits);
	scree_release(r->asked);
	scree_release(r->allowed);
	scree_release(r->rows);
}
