// SPDX-License-Identifier: MIT
// query_single.c -- answers queries with one result each: the first, any, or the nearest collidable.
#include "api/query/query_check.h"
#include "platform/processor.h"
#include "world/check.h"
#include "world/device/auto.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/upload/readers.h"
#include <stddef.h>

// the device reads and writes the user's arrays directly
_Static_assert(sizeof(scree_ray) == sizeof(Query) && offsetof(scree_ray, ignored) == offsetof(Query, ignored) &&
                   offsetof(scree_ray, radius) == offsetof(Query, b),
               "a ray is a Query");
_Static_assert(sizeof(scree_probe) == sizeof(Query) && offsetof(scree_probe, ignored) == offsetof(Query, ignored) &&
                   offsetof(scree_probe, translation) == offsetof(Query, b),
               "a probe is a Query");
_Static_assert(sizeof(scree_query_result) == sizeof(QueryResult) &&
                   offsetof(scree_query_result, fraction) == offsetof(QueryResult, fraction) &&
                   offsetof(scree_query_result, hit) == offsetof(QueryResult, marks),
               "a query result is a QueryResult");

static scree_status answer(scree_world* world, const char* function, const QueryRequest* questions,
                           scree_query_result* found)
{
	TRY(check_batch(function, "found", found, questions->count));
	if (questions->count == 0)
		return SCREE_OK;
	Reading reading;
	QueryResult* results = (QueryResult*)(void*)found;
	TRY(readers_begin(world, questions->count, &reading));
	double begin = auto_clock();
	scree_status status = reading_is_alone(&reading) ? queries_answer(&world->pipeline, questions, results)
	                                                 : search_answer(&world->pipeline, questions, results);
	readers_count(world, begin);
	readers_end(world, &reading);
	return world_note(world, status);
}

scree_status api_world_prepare_queries(scree_world* world)
{
	FLOAT_MODE_HERE;
	TRY(world_check(world, "scree_world_prepare_queries"));
	return readers_prepare(world);
}

static scree_status cast_rays(scree_world* world, const char* function, const char* name, const scree_query_def* def,
                              const scree_ray* rays, int count, scree_query_result* found)
{
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, def, rays, name, count, &query_items, &questions));
	query_rays(&query_items, &questions);
	return answer(world, function, &questions, found);
}

scree_status api_world_cast_rays(scree_world* world, const scree_query_def* def, const scree_ray* rays, int count,
                                 scree_query_result* found)
{
	FLOAT_MODE_HERE;
	return cast_rays(world, "scree_world_cast_rays", "rays", def, rays, count, found);
}

scree_status api_world_cast_ray(scree_world* world, scree_vec origin, scree_vec translation, scree_query_result* found)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_cast_ray";
	scree_ray ray = {.origin = origin, .translation = translation};
	TRY(check_vec((ArgumentPlace){function, "origin", ALONE}, "", origin, SCREE_MAX_COORDINATE));
	TRY(check_vec((ArgumentPlace){function, "translation", ALONE}, "", translation, 2.0f * SCREE_MAX_COORDINATE));
	return cast_rays(world, function, "ray", NULL, &ray, 1, found);
}

static scree_status cast_shapes(scree_world* world, const char* function, const char* name, const scree_query_def* def,
                                const scree_shape* shape, const scree_probe* probes, int count,
                                scree_query_result* found)
{
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, def, probes, name, count, &query_items, &questions));
	TRY(query_probes(world, shape, &query_items, &questions));
	return answer(world, function, &questions, found);
}

scree_status api_world_cast_shapes(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                   const scree_probe* probes, int count, scree_query_result* found)
{
	FLOAT_MODE_HERE;
	return cast_shapes(world, "scree_world_cast_shapes", "probes", def, shape, probes, count, found);
}

scree_status api_world_cast_shape(scree_world* world, const scree_shape* shape, scree_pose pose, scree_vec translation,
                                  scree_query_result* found)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_cast_shape";
	scree_probe probe = {.pose = pose, .translation = translation};
	TRY(check_pose((ArgumentPlace){function, "pose", ALONE}, "", &pose));
	TRY(check_vec((ArgumentPlace){function, "translation", ALONE}, "", translation, 2.0f * SCREE_MAX_COORDINATE));
	return cast_shapes(world, function, "probe", NULL, shape, &probe, 1, found);
}

scree_status api_world_find_nearest(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                    const scree_probe* probes, int count, float distance, scree_query_result* found)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_find_nearest";
	QueryItems query_items;
	QueryRequest questions;
	TRY(query_check(world, function, def, probes, "probes", count, &query_items, &questions));
	if (questions.any)
		return fail(SCREE_ERROR_INVALID, "%s: def.any is true, but the nearest cannot be any", function);
	TRY(check_real((ArgumentPlace){function, "distance", ALONE}, "", distance, 0.0f, FLT_MAX));
	TRY(query_probes(world, shape, &query_items, &questions));
	query_items.longest = 0.0f;
	questions.form = QUERY_NEAREST;
	// no two points of the world are as far apart as the upper limit, and its square is finite
	questions.plan.most = distance < 4.0f * SCREE_MAX_COORDINATE ? distance : 4.0f * SCREE_MAX_COORDINATE;
	return answer(world, function, &questions, found);
}
