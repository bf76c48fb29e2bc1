// SPDX-License-Identifier: MIT
// report_all.c -- sets all collidables of bodies to report touches and hits, so that the viewer can show these events.
#include "view/window/report_all.h"
#include <stdlib.h>

typedef struct
{
	scree_collidable* list;
	int count;
} Collidables;

// Lists the collidables of all bodies. The caller frees the list.
static scree_status list_all(scree_world* world, Collidables* all)
{
	scree_counters counters;
	int bodies = 0, count;
	*all = (Collidables){0};
	scree_status status = scree_world_get_counters(world, &counters);
	if (status == SCREE_OK)
		status = scree_world_get_bodies(world, NULL, 0, &bodies);
	if (status != SCREE_OK)
		return status;
	scree_body* list = malloc(((size_t)bodies + 1) * sizeof *list);
	all->list = malloc(((size_t)counters.collidables + 1) * sizeof *all->list);
	status = list && all->list ? scree_world_get_bodies(world, list, bodies, &bodies) : SCREE_ERROR_OUT_OF_MEMORY;
	for (int k = 0; k < bodies && status == SCREE_OK; ++k)
	{
		status = scree_body_get_collidables(world, list[k], all->list + all->count, counters.collidables - all->count,
		                                    &count);
		all->count += count;
	}
	free(list);
	return status;
}

scree_status reports_count(scree_world* world, uint32_t bits, int* count)
{
	Collidables all;
	scree_status status = list_all(world, &all);
	*count = 0;
	for (int k = 0; k < all.count && status == SCREE_OK; ++k)
	{
		uint32_t own = 0;
		status = scree_collidable_get_reports(world, all.list[k], &own);
		*count += (own & bits) != 0;
	}
	free(all.list);
	return status;
}

scree_status reports_all(scree_world* world)
{
	Collidables all;
	scree_status status = list_all(world, &all);
	uint32_t* bits = status == SCREE_OK ? malloc(((size_t)all.count + 1) * sizeof *bits) : NULL;
	for (int k = 0; k < all.count && bits; ++k)
		bits[k] = SCREE_REPORT_TOUCHES | SCREE_REPORT_HITS;
	if (status == SCREE_OK)
		status = bits ? scree_collidables_set_reports(world, all.list, bits, all.count) : SCREE_ERROR_OUT_OF_MEMORY;
	free(bits);
	free(all.list);
	return status;
}
