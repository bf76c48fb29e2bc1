// SPDX-License-Identifier: MIT
// query_shared.c -- answers queries in device memory that another program fills; the results go to the same memory.
#include "api/query/query_check.h"
#include "platform/processor.h"
#include "world/device/shared_buffers.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/upload/upload.h"

scree_status api_world_share_queries(scree_world* world, int file_descriptor, size_t bytes)
{
	FLOAT_MODE_HERE;
	return world_share(world, "scree_world_share_queries", "queries", SHARED_QUERIES,
	                   &(SharedMemory){.how = SCREE_SHARING_MEMORY, .file = file_descriptor, .bytes = bytes});
}

static scree_status check_place(const scree_world* world, const char* function, const char* name, size_t offset,
                                int count)
{
	size_t bytes = world->shared[SHARED_QUERIES], all = sizeof(Query) * (size_t)count;
	if (offset % 4 != 0)
		return fail(SCREE_ERROR_INVALID, "%s: %s is %zu, must be a multiple of 4", function, name, offset);
	if (all > bytes || offset > bytes - all)
		return fail(SCREE_ERROR_INVALID,
		            "%s: %s is %zu: %d items of 32 bytes do not fit into the %zu bytes that are shared", function, name,
		            offset, count, bytes);
	return SCREE_OK;
}

static scree_status check_shared(const scree_world* world, const char* function, const char* name, size_t items,
                                 int count, size_t found)
{
	if (world->shared[SHARED_QUERIES] == 0)
		return fail(SCREE_ERROR_INVALID, "%s: nothing is shared; scree_world_share_queries comes first", function);
	if (count < 0)
		return fail(SCREE_ERROR_INVALID, "%s: count is %d, must not be negative", function, count);
	TRY(check_place(world, function, name, items, count));
	return check_place(world, function, "found_offset", found, count);
}

static scree_status answer(scree_world* world, QueryRequest* questions, size_t items, int count, size_t found)
{
	questions->check = NULL;
	questions->count = count;
	questions->items_at = items;
	questions->found_at = found;
	if (count == 0)
		return SCREE_OK;
	TRY(world_upload(world));
	return world_note(world, queries_answer(&world->pipeline, questions, NULL));
}

scree_status api_world_cast_shared_rays(scree_world* world, const scree_query_def* def, size_t rays_offset, int count,
                                        size_t found_offset)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_cast_shared_rays";
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, def, NULL, "rays", 0, &query_items, &questions));
	TRY(check_shared(world, function, "rays_offset", rays_offset, count, found_offset));
	query_rays(&query_items, &questions);
	return answer(world, &questions, rays_offset, count, found_offset);
}

scree_status api_world_cast_shared_shapes(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                          size_t probes_offset, int count, size_t found_offset)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_cast_shared_shapes";
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, def, NULL, "probes", 0, &query_items, &questions));
	TRY(check_shared(world, function, "probes_offset", probes_offset, count, found_offset));
	TRY(query_probes(world, shape, &query_items, &questions));
	return answer(world, &questions, probes_offset, count, found_offset);
}
