// SPDX-License-Identifier: MIT
// world_order.c -- orders the worlds of a batch by tuning.
#include "batch/world_order.h"
#include "platform/error.h"

// Sets the number of the tuning of each template. Returns the number of different ones.
static int find_groups(const Template* templates, int count, int* group)
{
	int groups = 0;
	for (int t = 0; t < count; ++t)
	{
		group[t] = groups;
		for (int other = 0; other < t && group[t] == groups; ++other)
			if (template_fits(templates + t, templates + other))
				group[t] = group[other];
		groups += group[t] == groups;
	}
	return groups;
}

static scree_status no_memory(int worlds)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the order of %d worlds", worlds);
}

// Sorts the worlds by the groups of their templates.
static scree_status sort_worlds(WorldOrder* order, const int* group, const int* template_of, int worlds)
{
	order->world = scree_allocate(sizeof *order->world * (size_t)worlds);
	order->place = scree_allocate(sizeof *order->place * (size_t)worlds);
	if (!order->world || !order->place)
		return no_memory(worlds);
	for (int k = 0; k < worlds; ++k)
		++order->end[group[template_of[k]]];
	for (int g = 0, sum = 0; g < order->groups; ++g)
	{
		int count = order->end[g];
		order->end[g] = sum; // the first place, which the loop below moves to the end
		sum += count;
	}
	for (int k = 0; k < worlds; ++k)
	{
		int place = order->end[group[template_of[k]]]++;
		order->world[place] = k;
		order->place[k] = place;
	}
	return SCREE_OK;
}

scree_status order_open(WorldOrder* order, const Template* templates, int count, const int* template_of, int worlds)
{
	int* group = scree_allocate(sizeof *group * (size_t)count);
	order->groups = group ? find_groups(templates, count, group) : 1;
	order->end = scree_allocate(sizeof *order->end * (size_t)order->groups);
	scree_status status = group && order->end ? SCREE_OK : no_memory(worlds);
	if (status == SCREE_OK && order->groups > 1)
		status = sort_worlds(order, group, template_of, worlds);
	else if (status == SCREE_OK)
		order->end[0] = worlds;
	scree_release(group);
	return status;
}

void order_close(WorldOrder* order)
{
	scree_release(order->world);
	scree_release(order->place);
	scree_release(order->end);
}
