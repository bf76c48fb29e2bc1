// SPDX-License-Identifier: MIT
// step_queries.h -- queries of the user on the world as it is now: trees of the poses, searches, answers in order.
#ifndef STEP_QUERIES_H
#define STEP_QUERIES_H
#include "step/pipeline_state.h"

typedef struct // generations of the handles of slots
{
	const uint32_t* generation;
	int count;        // of slots
	uint64_t version; // another one when some generation changed
} Names;

typedef struct // what is asked
{
	int form;          // QUERY_RAYS, ...
	bool any;          // only whether there is an answer
	QueryPlan plan;    // without room, found and bodies
	const void* items; // of the layout of Query; null for those in the memory shared for queries, from an offset
	size_t items_at, found_at; // and the offset of their answers there
	int count;
	Names collidables, bodies;
	bool timings;
	// of items begin to end - 1, by any thread while the device works: an answer is read only if all are good. Searches end whatever
	// the items are
	scree_status (*check)(const void* context, int begin, int end);
	const void* context; // of check
} QueryRequest;

// The answer of each query; found is null for those whose items are. The user's changes are on the device.
scree_status queries_answer(Pipeline* pipeline, const QueryRequest* questions, QueryResult* found);

// All answers: sets *count to their number, and lists them in the pools found_row and found_row_query, by their queries, then by
// their fractions, then by their collidables; or, when there are at most FEW_ANSWERS, in found and found_query, in no order.
#define FEW_ANSWERS 64
scree_status queries_list(Pipeline* pipeline, const QueryRequest* questions, int* count);

// Reads so many answers from there, and the query of each.
scree_status queries_read(Pipeline* pipeline, int count, QueryResult* found, int* queries);

// Counts the bodies, of so many slots, at other poses than the user was told last.
scree_status moved_count(Pipeline* pipeline, int bodies, int* count);

// Lists those that were just counted in the pool moved_row, by index. From then on the user has been told.
scree_status moved_list(Pipeline* pipeline, int bodies, int count);

#endif
