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
#include "world/upload/readers.h"

// Most results of a list that a thread sorts itself, beside other threads.
#define SEARCHED_ANSWERS 1024
#define FIRST_ANSWERS    64

// Returns whether a result comes after another one: by query, then fraction, then collidable. No two are equal.
static bool comes_after(const QueryResult* a, int query_a, const QueryResult* b, int query_b)
{
	if (query_a != query_b)
		return query_a > query_b;
	return a->fraction != b->fraction ? a->fraction > b->fraction : a->collidable > b->collidable;
}

// Donald Shell, A High-Speed Sorting Procedure, 1959, with Knuth's gaps; few results are sorted by insertion.
static void sort_rows(QueryResult* found, int* query, int count)
{
	int gap = 1;
	while (gap < count / 9)
		gap = 3 * gap + 1;
	for (; gap > 0; gap /= 3)
	{
		for (int k = gap; k < count; ++k)
		{
			QueryResult row = found[k];
			int of = query[k], place = k;
			for (; place >= gap && comes_after(found + place - gap, query[place - gap], &row, of); place -= gap)
			{
				found[place] = found[place - gap];
				query[place] = query[place - gap];
			}
			found[place] = row;
			query[place] = of;
		}
	}
}

static scree_status reserve_rows(const char* function, Queries* q, int count)
{
	TRY(GROW(function, q->found, q->capacity, count));
	return GROW(function, q->query, q->query_capacity, count);
}

static scree_status read_rows(scree_world* world, const char* function, Queries* q, int count)
{
	TRY(reserve_rows(function, q, count));
	TRY(queries_read(&world->pipeline, count, q->found, q->query));
	if (count <= FEW_ANSWERS)
		sort_rows(q->found, q->query, count);
	return SCREE_OK;
}

// Makes the list beside other threads. *count: number of results; if it exceeds SEARCHED_ANSWERS, there is no list.
static scree_status search_rows(const scree_world* world, const char* function, Queries* q,
                                const QueryRequest* questions, int* count)
{
	TRY(reserve_rows(function, q, FIRST_ANSWERS));
	for (;;)
	{
		int room = q->capacity < q->query_capacity ? q->capacity : q->query_capacity;
		TRY(search_list(&world->pipeline, questions, q->found, q->query, room, count));
		if (*count <= room)
			break;
		if (*count > SEARCHED_ANSWERS)
			return SCREE_OK;
		TRY(reserve_rows(function, q, *count));
	}
	if (*count <= SEARCHED_ANSWERS)
		sort_rows(q->found, q->query, *count);
	return SCREE_OK;
}

static scree_status read_list(scree_world* world, const char* function, Queries* q, const QueryRequest* questions,
                              Reading* reading, int* count)
{
	TRY(GROW(function, q->first, q->first_capacity, questions->count + 1));
	*count = 0;
	if (questions->count > 0 && !reading_is_alone(reading))
	{
		TRY(search_rows(world, function, q, questions, count));
		if (*count > SEARCHED_ANSWERS)
			readers_alone(world, reading);
	}
	if (questions->count > 0 && reading_is_alone(reading))
	{
		TRY(queries_list(&world->pipeline, questions, count));
		if (*count > 0)
			TRY(read_rows(world, function, q, *count));
	}
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
	Queries* q = readers_queries(world, function);
	if (!q)
		return SCREE_ERROR_OUT_OF_MEMORY;
	Reading reading;
	TRY(readers_begin(world, questions->count, &reading));
	double begin = auto_clock();
	int count;
	scree_status status = read_list(world, function, q, questions, &reading, &count);
	readers_count(world, begin);
	readers_end(world, &reading);
	TRY(world_note(world, status));
	scree_query_results result = {.size = (uint32_t)size,
	                              .count = count,
	                              .results = (const scree_query_result*)(const void*)q->found,
	                              .first = q->first};
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
