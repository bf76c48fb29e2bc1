// SPDX-License-Identifier: MIT
// exclusion.c -- adds, removes and lists pairs of bodies that never touch.
#include "platform/processor.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/exclusions.h"
#include "world/objects/handles.h"
#include "world/objects/sleep.h"
#include "world/record/api_calls.h"
#include <stdlib.h>

static scree_status check_pair(const scree_world* world, const char* function, const char* const arguments[2], int k,
                               scree_body a, scree_body b, int bodies[2])
{
	TRY(check_body(world, (ArgumentPlace){function, arguments[0], k}, "", a, bodies));
	TRY(check_body(world, (ArgumentPlace){function, arguments[1], k}, "", b, bodies + 1));
	if (bodies[0] == bodies[1])
		return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, arguments[1], k}, "",
		              "is the same body (index %u) as %s: a body never touches itself", b.index, arguments[0]);
	return SCREE_OK;
}

static void set(scree_world* world, int a, int b, bool excluded)
{
	body_note_wake(world, a);
	body_note_wake(world, b);
	exclusion_set(world, a, b, excluded);
}

scree_status api_bodies_set_excluded(scree_world* world, const scree_body* a, const scree_body* b, const bool* excluded,
                                     int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_bodies_set_excluded";
	const char* const arguments[2] = {"a", "b"};
	int bodies[2];
	TRY(world_check(world, function));
	TRY(check_batch(function, "a", a, count));
	TRY(check_batch(function, "b", b, count));
	TRY(check_batch(function, "excluded", excluded, count));
	for (int k = 0; k < count; ++k)
		TRY(check_pair(world, function, arguments, k, a[k], b[k], bodies));
	TRY(exclusions_reserve(world, function, count));
	TRY(edits_reserve(world, function, 0, 0, 2 * count));
	for (int k = 0; k < count; ++k)
		set(world, (int)a[k].index, (int)b[k].index, excluded[k]);
	return SCREE_OK;
}

scree_status api_body_set_excluded(scree_world* world, scree_body body, scree_body other, bool excluded)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_excluded";
	const char* const arguments[2] = {"body", "other"};
	int bodies[2];
	TRY(world_check(world, function));
	TRY(check_pair(world, function, arguments, ALONE, body, other, bodies));
	TRY(exclusions_reserve(world, function, 1));
	TRY(edits_reserve(world, function, 0, 0, 2));
	set(world, bodies[0], bodies[1], excluded);
	return SCREE_OK;
}

bool scree_body_is_excluded(const scree_world* world, scree_body body, scree_body other)
{
	return scree_body_is_valid(world, body) && scree_body_is_valid(world, other) &&
	       exclusion_find(world, (int)body.index, (int)other.index) >= 0;
}

static int compare_bodies(const void* a, const void* b)
{
	uint32_t first = ((const scree_body*)a)->index, second = ((const scree_body*)b)->index;
	return first < second ? -1 : first > second;
}

scree_status api_body_get_excluded(scree_world* world, scree_body body, scree_body* others, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_excluded";
	int index = 0, listed = 0;
	TRY(world_check(world, function));
	TRY(check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, &index));
	TRY(check_list(function, "others", others, capacity, count));
	const HostBody* host = world->host_bodies + index;
	// the list has the newest pair first, so all bodies are sorted by index before `capacity` limits their number
	scree_body* all = world_scratch(world, (size_t)host->exclusions * sizeof *all);
	if (!all && host->exclusions > 0)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d bodies", function, host->exclusions);
	for (int end = host->first_exclusion; end > 0; end = exclusion_next(world, end))
		all[listed++] = body_handle(world, exclusion_other(world, end));
	if (listed > 1)
		qsort(all, (size_t)listed, sizeof *all, compare_bodies);
	for (int k = 0; k < listed && k < capacity; ++k)
		others[k] = all[k];
	*count = listed;
	return SCREE_OK;
}
