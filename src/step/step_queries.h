// SPDX-License-Identifier: MIT
// step_queries.h -- queries of the user on the current world: trees of the current poses, searches, sorted answers.
#ifndef STEP_QUERIES_H
#define STEP_QUERIES_H
#include "step/pipeline_state.h"

typedef struct // generations of the handles of slots
{
	const uint32_t* generation;
	int count;        // number of slots
	uint64_t version; // changes whenever some generation changes
} Names;

typedef struct // a call of queries
{
	int form;          // QUERY_RAYS, ...
	bool any;          // only whether some answer exists
	QueryPlan plan;    // without room, found and bodies
	const void* items; // in the layout of Query; null for queries in the memory shared for queries, from an offset on
	size_t items_at, found_at; // that offset, and the offset of the answers there
	int count;
	Names collidables, bodies;
	bool timings;
	// Checks items begin to end - 1 in any thread; answers are read only if all are valid. Searches end in any case.
	scree_status (*check)(const void* context, int begin, int end);
	const void* context; // argument of check
} QueryRequest;

// Computes the answer of each query, after the upload of the user's changes. found is null for items in shared memory.
scree_status queries_answer(Pipeline* pipeline, const QueryRequest* questions, QueryResult* found);

// Computes all answers, and their number *count. Lists them in the pools found_row and found_row_query by query, then
// fraction, then collidable; or, if there are at most FEW_ANSWERS, in found and found_query, unordered.
#define FEW_ANSWERS 64
scree_status queries_list(Pipeline* pipeline, const QueryRequest* questions, int* count);
scree_status queries_read(Pipeline* pipeline, int count, QueryResult* found, int* queries);

// Counts the bodies whose pose differs from the last one that the user read; bodies is the number of slots.
scree_status moved_count(Pipeline* pipeline, int bodies, int* count);

// Lists the bodies that were just counted in the pool moved_row, by index. Their poses then count as read.
scree_status moved_list(Pipeline* pipeline, int bodies, int count);

#endif
