// SPDX-License-Identifier: MIT
// step_queries.c -- executes queries: computes trees for the current poses, searches them, and sorts the results.
#include "step/step_queries.h"
#include "platform/error.h"
#include "step/dispatch.h"
#include "step/reserve.h"
#include "step/stage_lists.h"
#include "step/tree_maintenance.h"

#define FIRST_ANSWERS  256 // initial capacity of a list of results
#define APPENDED_SHARE 8   // sorts leaves if more than 1 / APPENDED_SHARE of them were appended since the last sort

#define REFIT_RUNS (2 * 2 * (MAX_LEVELS + 4)) // maximum number of runs: both trees are refitted twice and sorted

// Lists the runs that compute the boxes of tree t for queries. ways: true for boxes around the motion of the last step.
static void list_refit(Pipeline* pipeline, int t, bool ways)
{
	int how = (ways ? TREE_PATHS : 0) | (pipeline->reverted ? TREE_STALE : 0);
	list_tree(&pipeline->list, &pipeline->trees[t], KERNEL_query_leaf, KERNEL_query_node, t | how, NO_COUNT);
}

// Lists the runs that compute the boxes for queries of the collidables in active groups, and of the nodes above them.
static void list_refit_active(Pipeline* pipeline, bool ways)
{
	RunList* list = &pipeline->list;
	runs_add_single(list, KERNEL_query_stale_none);
	list_new_leaves(list, &pipeline->trees[0]);
	runs_add(list, KERNEL_query_leaf_active, 0, pipeline->backend->capacity[PER_COLLIDABLE],
	         COUNT(active_items) + GROUPS_OF_COLLIDABLES, ways ? TREE_PATHS : 0);
	list_stale_nodes(list, &pipeline->trees[0].tree, KERNEL_query_node);
}

// Returns whether all boxes for queries that may be out of date belong to collidables in active groups: groups rest 8
// steps after their last change at the earliest, and the boxes were computed later than 8 steps ago.
static bool rest_is_boxed(const Pipeline* pipeline, int t)
{
	const TreeState* state = &pipeline->trees[t];
	return t == 0 && pipeline->sleeps && pipeline->listed && !pipeline->reverted && state->change != TREE_MOVED &&
	       state->boxed > 0 && pipeline->steps + 1 - state->boxed < SLEEP_STEPS;
}

// Sorts the leaves of a tree, which are in the order of creation until a step or a query has sorted them.
static scree_status order(Pipeline* pipeline, int t)
{
	list_refit(pipeline, t, false);
	list_leaf_order(&pipeline->list, &pipeline->trees[t].tree, t, TREE_QUERIES, NO_COUNT);
	TRY(pipeline_run(pipeline, &pipeline->step));
	pipeline->trees[t].change = TREE_MOVED; // the leaves have new places, so the step computes all boxes of nodes
	return tree_ordered(pipeline, t);
}

static scree_status refit(Pipeline* pipeline, bool ways)
{
	Backend* b = pipeline->backend;
	TRY(runs_reserve(&pipeline->list, REFIT_RUNS));
	TRY(tree_upload(pipeline));
	TRY(pipeline_reserve(pipeline, PER_QUERY_LEAF, b->capacity[PER_LEAF]));
	TRY(pipeline_reserve(pipeline, PER_QUERY_NODE, b->capacity[PER_NODE]));
	for (int t = 0; t < 2; ++t)
	{
		TreeState* state = &pipeline->trees[t];
		bool moves = ways && t == 0; // static boxes do not move
		if ((state->seen && !moves) || state->tree.leaves == 0)
			continue;
		if (state->tree.leaves > ARITY && state->appended > state->tree.leaves / APPENDED_SHARE)
			TRY(order(pipeline, t));
		if (rest_is_boxed(pipeline, t))
			list_refit_active(pipeline, moves);
		else
			list_refit(pipeline, t, moves);
		TRY(pipeline_run(pipeline, &pipeline->step));
		state->seen = !moves;
		state->boxed = pipeline->steps + 1;
	}
	return SCREE_OK;
}

static scree_status lap(Pipeline* pipeline, const QueryRequest* q)
{
	double stage_times[STAGE_COUNT];
	if (!q->timings)
		return SCREE_OK;
	TRY(pipeline->backend->f->timings(pipeline->backend, stage_times));
	pipeline->query_milliseconds = 0.0;
	for (int k = 0; k < STAGE_COUNT; ++k)
		pipeline->query_milliseconds += stage_times[k];
	return SCREE_OK;
}

// Writes the generations that changed since the last query.
static scree_status send_names(Backend* b, PoolId pool, const Names* names, uint64_t* sent)
{
	if (*sent == names->version || names->count == 0)
		return SCREE_OK;
	bool few = *sent > 0 && names->version - *sent <= (uint64_t)names->logged;
	for (uint64_t k = few ? *sent + 1 : 1; few && k <= names->version; ++k)
	{
		int slot = names->changed[k % (uint64_t)names->logged];
		if (slot < names->count)
			TRY(b->f->write(b, pool, slot, 1, names->generation + slot));
	}
	if (!few)
		TRY(b->f->write(b, pool, 0, names->count, names->generation));
	*sent = names->version;
	return SCREE_OK;
}

// bodies: null for sensors, which ignore no body, but see the motion of the last step.
static scree_status prepare_trees(Pipeline* pipeline, const Names* collidables, const Names* bodies)
{
	Backend* b = pipeline->backend;
	TRY(refit(pipeline, !bodies));
	TRY(send_names(b, POOL_generation, collidables, &pipeline->named));
	return bodies ? send_names(b, POOL_body_generation, bodies, &pipeline->named_bodies) : SCREE_OK;
}

static scree_status prepare(Pipeline* pipeline, const QueryRequest* q)
{
	TRY(lap(pipeline, q));
	TRY(prepare_trees(pipeline, &q->collidables, q->form == QUERY_SENSORS ? NULL : &q->bodies));
	return pipeline_reserve(pipeline, PER_QUERY, q->count);
}

static scree_status send_plan(Pipeline* pipeline, const QueryRequest* q, int room)
{
	Backend* b = pipeline->backend;
	QueryPlan plan = q->plan;
	plan.room = room;
	plan.bodies = q->bodies.count;
	return b->f->write(b, POOL_query_plan, 0, 1, &plan);
}

static Run search_of(const Pipeline* pipeline, const QueryRequest* q, int mode)
{
	static const int stages[] = {
	    [QUERY_RAYS] = KERNEL_query_ray,
	    [QUERY_SHAPES] = KERNEL_query_shape,
	    [QUERY_NEAREST] = KERNEL_query_nearest,
	    [QUERY_SENSORS] = KERNEL_sensor_overlap,
	};
	Run run = {.kernel_id = stages[q->form], .end = q->count, .count = NO_COUNT, .argument = mode};
	if (q->form == QUERY_SENSORS)
	{
		// several work-items share the search for one sensor if there are more work-items than sensors
		int parts = pipeline->backend->traversal_items / q->count, blocks = (q->collidables.count + ARITY - 1) / ARITY;
		run.argument = parts < 1 ? 1 : parts < blocks ? parts : blocks;
		run.end = q->count * run.argument;
	}
	return run;
}

scree_status queries_answer(Pipeline* pipeline, const QueryRequest* q, QueryResult* found)
{
	Backend* b = pipeline->backend;
	Run run = search_of(pipeline, q, q->any ? QUERY_ANY : QUERY_CLOSEST);
	TRY(prepare(pipeline, q));
	TRY(pipeline_reserve(pipeline, PER_FOUND, q->count));
	TRY(send_plan(pipeline, q, 0));
	if (q->items)
	{
		RoundTrip trip = {.asked = POOL_query,
		                  .items = q->items,
		                  .run = run,
		                  .answered = POOL_found,
		                  .answers = found,
		                  .check = q->check,
		                  .context = q->context};
		TRY(b->f->round_trip(b, &pipeline->step, &trip));
		return lap(pipeline, q);
	}
	TRY(b->f->download(b, SHARED_QUERIES, POOL_query, 0, q->count, q->items_at));
	TRY(b->f->run(b, &pipeline->step, &run, 1));
	TRY(b->f->upload(b, SHARED_QUERIES, POOL_found, 0, q->count, q->found_at));
	return lap(pipeline, q);
}

scree_status searches_prepare(Pipeline* pipeline, const Names* collidables, const Names* bodies)
{
	Backend* b = pipeline->backend;
	TRY(prepare_trees(pipeline, collidables, bodies));
	if (b->f->searches_open)
		b->f->searches_open(b);
	return SCREE_OK;
}

// Executes a search. mode: QUERY_*; queries, room, *count: as in search_list.
static scree_status search(const Pipeline* pipeline, const QueryRequest* q, int mode, QueryResult* found, int* queries,
                           int room, int* count)
{
	Backend* b = pipeline->backend;
	Run run = search_of(pipeline, q, mode);
	QueryPlan plan = q->plan;
	plan.bodies = q->bodies.count;
	plan.room = room;
	TRY(q->check(q->context, 0, q->count));
	b->f->search(b, &(Search){.kernel = run.kernel_id,
	                          .argument = run.argument,
	                          .count = q->count,
	                          .queries = q->items,
	                          .plan = &plan,
	                          .found = found,
	                          .found_query = queries});
	*count = plan.found;
	return SCREE_OK;
}

scree_status search_answer(const Pipeline* pipeline, const QueryRequest* q, QueryResult* found)
{
	int unused;
	return search(pipeline, q, q->any ? QUERY_ANY : QUERY_CLOSEST, found, NULL, 0, &unused);
}

scree_status search_list(const Pipeline* pipeline, const QueryRequest* q, QueryResult* found, int* queries, int room,
                         int* count)
{
	return search(pipeline, q, QUERY_ALL, found, queries, room, count);
}

static scree_status sort(Pipeline* pipeline, const QueryRequest* q, int count)
{
	RunList* list = &pipeline->list;
	TRY(pipeline_reserve(pipeline, PER_KEY, count));
	TRY(runs_reserve(list, 7));
	runs_add(list, KERNEL_query_key, 0, count, NO_COUNT, QUERY_BY_COLLIDABLE);
	runs_add_sort(list, count, NO_COUNT, 32, 32 + index_bits(q->collidables.count + 1));
	if (q->form != QUERY_SENSORS)
	{
		runs_add(list, KERNEL_query_key, 0, count, NO_COUNT, QUERY_BY_FRACTION);
		runs_add_sort(list, count, NO_COUNT, 32, 64);
	}
	runs_add(list, KERNEL_query_key, 0, count, NO_COUNT, QUERY_BY_QUERY);
	runs_add_sort(list, count, NO_COUNT, 32, 32 + index_bits(q->count));
	runs_add(list, KERNEL_query_list, 0, count, NO_COUNT, 0);
	return pipeline_run(pipeline, &pipeline->step);
}

scree_status queries_list(Pipeline* pipeline, const QueryRequest* q, int* count)
{
	Backend* b = pipeline->backend;
	TRY(prepare(pipeline, q));
	TRY(b->f->write(b, POOL_query, 0, q->count, q->items));
	TRY(pipeline_reserve(pipeline, PER_FOUND, FIRST_ANSWERS));
	for (;;)
	{
		int room = b->capacity[PER_FOUND];
		QueryPlan plan;
		Run run = search_of(pipeline, q, QUERY_ALL);
		TRY(send_plan(pipeline, q, room));
		TRY(b->f->run(b, &pipeline->step, &run, 1));
		if (q->check)
			TRY(q->check(q->context, 0, q->count));
		TRY(b->f->read(b, POOL_query_plan, 0, 1, &plan));
		*count = plan.found;
		if (plan.found > QUERY_MOST)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%d queries have more than %d answers: ask fewer at once", q->count,
			            QUERY_MOST);
		if (plan.found <= room)
			break;
		TRY(pipeline_reserve(pipeline, PER_FOUND, plan.found));
	}
	if (*count > FEW_ANSWERS)
		TRY(sort(pipeline, q, *count));
	return lap(pipeline, q);
}

scree_status queries_read(Pipeline* pipeline, int count, QueryResult* found, int* queries)
{
	Backend* b = pipeline->backend;
	bool few = count <= FEW_ANSWERS;
	TRY(b->f->read(b, few ? POOL_found_query : POOL_found_row_query, 0, count, queries));
	return b->f->read(b, few ? POOL_found : POOL_found_row, 0, count, found);
}

scree_status moved_count(Pipeline* pipeline, int bodies, int* count)
{
	Backend* b = pipeline->backend;
	RunList* list = &pipeline->list;
	pipeline->tells = true;
	TRY(runs_reserve(list, 2));
	runs_add_single(list, KERNEL_moved_begin);
	runs_add(list, KERNEL_moved_mark, 1, bodies, NO_COUNT, 0); // body 0 is the ground
	TRY(pipeline_run(pipeline, &pipeline->step));
	TRY(b->f->read(b, POOL_counters, 0, 1, &pipeline->counters));
	*count = pipeline->counters.moved_bodies;
	return SCREE_OK;
}

scree_status moved_list(Pipeline* pipeline, int bodies, int count)
{
	RunList* list = &pipeline->list;
	if (count == 0)
		return SCREE_OK;
	TRY(runs_reserve(list, 3));
	TRY(pipeline_reserve(pipeline, PER_KEY, count));
	TRY(pipeline_reserve(pipeline, PER_FOUND, count));
	runs_add(list, KERNEL_moved_key, 0, count, NO_COUNT, 0);
	runs_add_sort(list, count, NO_COUNT, 0, index_bits(bodies));
	runs_add(list, KERNEL_moved_list, 0, count, NO_COUNT, 0);
	return pipeline_run(pipeline, &pipeline->step);
}
