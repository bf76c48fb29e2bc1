// SPDX-License-Identifier: MIT
// query_list.c -- answers queries that return all their results in a list.
#include "api/query/query_check.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/device/auto.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/upload/upload.h"

static void sort_few(QueryResult* found, int* query, int count)
{
	for (int k = 1; k < count; ++k)
	{
		QueryResult row = found[k];
		int of = query[k], place = k;
		for (; place > 0; --place)
		{
			const QueryResult* before = found + place - 1;
			int that = query[place - 1];
			bool after = that != of                         ? that > of
			             : before->fraction != row.fraction ? before->fraction > row.fraction
			                                                : before->collidable > row.collidable;
			if (!after)
				break;
			found[place] = found[place - 1];
			query[place] = query[place - 1];
		}
		found[place] = row;
		query[place] = of;
	}
}

static scree_status read_rows(scree_world* world, const char* function, int count)
{
	Queries* q = &world->queries;
	TRY(GROW(function, q->found, q->capacity, count));
	TRY(GROW(function, q->query, q->query_capacity, count));
	TRY(queries_read(&world->pipeline, count, q->found, q->query));
	if (count <= FEW_ANSWERS)
		sort_few(q->found, q->query, count);
	return SCREE_OK;
}

static scree_status read_list(scree_world* world, const char* function, const QueryRequest* questions, int* count)
{
	Queries* q = &world->queries;
	TRY(GROW(function, q->first, q->first_capacity, questions->count + 1));
	*count = 0;
	if (questions->count > 0)
		TRY(queries_list(&world->pipeline, questions, count));
	if (*count > 0)
		TRY(read_rows(world, function, *count));
	int k = 0;
	for (int n = 0; n <= questions->count; ++n)
	{
		while (k < *count && q->query[k] < n)
			++k;
		q->first[n] = k;
	}
	return SCREE_OK;
}

static scree_status list(scree_world* world, const char* function, const QueryRequest* questions,
                         scree_query_results* to, size_t size)
{
	TRY(check_pointer(function, "list", to));
	if (questions->any)
		return fail(SCREE_ERROR_INVALID, "%s: def.any is true, but a list has all", function);
	TRY(world_upload(world));
	double begin = auto_clock();
	int count;
	scree_status status = read_list(world, function, questions, &count);
	auto_count(world, begin);
	TRY(world_note(world, status));
	scree_query_results result = {.size = (uint32_t)size,
	                              .count = count,
	                              .results = (const scree_query_result*)(const void*)world->queries.found,
	                              .first = world->queries.first};
	write_result(to, size, &result, sizeof result);
	return SCREE_OK;
}

scree_status api_world_list_rays_sized(scree_world* world, const scree_query_def* def, const scree_ray* rays, int count,
                                       scree_query_results* to, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_list_rays";
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, def, rays, "rays", count, &query_items, &questions));
	query_rays(&query_items, &questions);
	return list(world, function, &questions, to, size);
}

scree_status api_world_list_shapes_sized(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                         const scree_probe* probes, int count, scree_query_results* to, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_list_shapes";
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, def, probes, "probes", count, &query_items, &questions));
	TRY(query_probes(world, shape, &query_items, &questions));
	return list(world, function, &questions, to, size);
}

scree_status api_world_overlap_box_sized(scree_world* world, scree_box box, scree_query_results* to, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_overlap_box";
	TRY(check_box(function, box));
	float half_x = 0.5f * (box.upper.x - box.lower.x), half_y = 0.5f * (box.upper.y - box.lower.y);
	scree_shape shape;
	TRY(scree_shape_make_box(half_x, half_y, &shape));
	scree_probe probe = {.pose = {{box.lower.x + half_x, box.lower.y + half_y}, {1.0f, 0.0f}}};
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, NULL, &probe, "box", 1, &query_items, &questions));
	TRY(query_probes(world, &shape, &query_items, &questions));
	return list(world, function, &questions, to, size);
}
