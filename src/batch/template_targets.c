// SPDX-License-Identifier: MIT
// template_targets.c -- reads the pending targets of kinematic bodies of a template.
#include "batch/template_targets.h"
#include "platform/error.h"
#include "world/check.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/hidden_hash.h"
#include "world/objects/targets.h"
#include "world/pool_values.h"
#include <stdlib.h>

static int compare(const void* a, const void* b)
{
	const TemplateTarget *x = a, *y = b;
	return (x->command.index > y->command.index) - (x->command.index < y->command.index);
}

scree_status targets_read(const scree_world* world, const char* function, int number, TemplateTargets* made)
{
	int count = world->target_count;
	if (count > MOST_TARGETS)
	{
		if (number == ALONE)
			return fail(SCREE_ERROR_INVALID, "%s: the world has %d pending targets, must have at most %d", function,
			            count, MOST_TARGETS);
		return fail(SCREE_ERROR_INVALID, "%s: template %d has %d pending targets, must have at most %d", function,
		            number, count, MOST_TARGETS);
	}
	made->items = scree_allocate(sizeof *made->items * (size_t)(count + 1));
	if (!made->items)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d targets of a template", function, count);
	made->count = count;
	for (int k = 0; k < count; ++k)
	{
		const Target* target = world->targets + k;
		const HostBody* host = world->host_bodies + target->body;
		TemplateTarget* to = made->items + k;
		to->command = (Command){.kind = COMMAND_TARGET, .index = target->body, .value = pose_row(target->pose)};
		to->command.whole[0] = (int)host->locks;
		to->command.whole[1] = command_bits(world, target->body) & COMMAND_JOINED;
		to->hash = hidden_hash_target(target->body, target->pose);
	}
	qsort(made->items, (size_t)count, sizeof *made->items, compare);
	return SCREE_OK;
}

uint64_t targets_all(const TemplateTargets* from)
{
	return from->count < MOST_TARGETS ? ((uint64_t)1 << from->count) - 1 : UINT64_MAX;
}

uint64_t targets_hash(const TemplateTargets* from, uint64_t set)
{
	uint64_t sum = 0;
	for (int k = 0; k < from->count; ++k)
		sum += set >> k & 1 ? from->items[k].hash : 0;
	return sum;
}

bool targets_find(const TemplateTargets* from, const TemplateTargets* read, uint64_t* set)
{
	*set = 0;
	for (int n = 0, k = 0; n < read->count; ++n, ++k)
	{
		while (k < from->count && from->items[k].hash != read->items[n].hash)
			++k;
		if (k == from->count)
			return false;
		*set |= (uint64_t)1 << k;
	}
	return true;
}

void targets_keep(const TemplateTargets* from, uint64_t set, scree_world* clone)
{
	for (int k = 0; k < from->count; ++k)
		if (!(set >> k & 1))
			target_drop(clone, from->items[k].command.index);
}
