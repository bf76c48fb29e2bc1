// SPDX-License-Identifier: MIT
// step_queries.h -- executes queries: computes trees for the current poses, searches them, and sorts the results.
#ifndef STEP_QUERIES_H
#define STEP_QUERIES_H
#include "step/pipeline_state.h"

typedef struct // generations of the handles of all slots
{
	const uint32_t* generation;
	int count;          // number of slots
	uint64_t version;   // number of changes of generations
	const int* changed; // slots of the last changes; change number n is entry n % logged
	int logged;         // number of changes that are logged
} Names;

typedef struct // arguments of a call that executes queries
{
	int form;                  // QUERY_RAYS, QUERY_SHAPES, QUERY_NEAREST or QUERY_SENSORS
	bool any;                  // true: finds only whether there is a query result
	QueryPlan plan;            // its members room, found and bodies are not set
	const void* items;         // array of Query; null if the queries are in the memory shared for queries, at items_at
	size_t items_at, found_at; // offsets of the queries and of their results in the shared memory
	int count;
	Names collidables, bodies;
	bool timings;
	// Checks queries `begin` to `end` - 1, in any thread. If one is invalid, all searches end, but no result is read.
	scree_status (*check)(const void* context, int begin, int end);
	const void* context; // argument of `check`
} QueryRequest;

// Computes the result of each query. The user's changes must be uploaded. found: null for queries in shared memory.
scree_status queries_answer(Pipeline* pipeline, const QueryRequest* questions, QueryResult* found);

// Prepares searches: computes the boxes for queries, and writes generations. The user's changes must be uploaded.
scree_status searches_prepare(Pipeline* pipeline, const Names* collidables, const Names* bodies);

// Do the same as queries_answer and queries_list on the calling thread, at the same time as other threads, after
// searches_prepare. search_list stores at most `room` results, unordered; *count: their total number.
scree_status search_answer(const Pipeline* pipeline, const QueryRequest* questions, QueryResult* found);
scree_status search_list(const Pipeline* pipeline, const QueryRequest* questions, QueryResult* found, int* queries,
                         int room, int* count);

// Computes all results of each query; *count: their total number. At most FEW_ANSWERS results are in the pools found
// and found_query, unordered; a larger number is in found_row and found_row_query, sorted by query, then fraction, then
// collidable.
#define FEW_ANSWERS 64
scree_status queries_list(Pipeline* pipeline, const QueryRequest* questions, int* count);
scree_status queries_read(Pipeline* pipeline, int count, QueryResult* found, int* queries);

// Sets *count to the number of bodies whose pose differs from the pose that the user read last. bodies: their slots.
scree_status moved_count(Pipeline* pipeline, int bodies, int* count);

// Lists the bodies that moved_count found, in the pool moved_row, sorted by index. Their poses then count as read.
scree_status moved_list(Pipeline* pipeline, int bodies, int count);

#endif
