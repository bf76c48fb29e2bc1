// SPDX-License-Identifier: MIT
// query_check.h -- checks of queries, and what the device is asked.
#ifndef QUERY_CHECK_H
#define QUERY_CHECK_H
#include "step/step_queries.h"
#include "world/check.h"
#include "world/world.h"

typedef struct // the items of a call, for their check
{
	const scree_world* world;
	const char* function;
	const void* items;
	float longest; // m: a component of a translation
} QueryItems;

scree_status check_query_kinds(ArgumentPlace at, uint32_t kinds);

// Checks what all queries have: the definition, and count items in an array. asking must live as long as questions.
scree_status query_check(scree_world* world, const char* function, const scree_query_def* def, const void* items,
                         const char* items_name, int count, QueryItems* query_items, QueryRequest* questions);

// The shape of a query, null for a point, as the device takes it.
scree_status query_shape_of(const char* function, const char* argument, const scree_shape* shape, Attribute* to);

// The items are rays; or probes with a shape, null for a point, which is checked at once.
void query_rays(QueryItems* query_items, QueryRequest* questions);
scree_status query_probes(scree_world* world, const scree_shape* shape, QueryItems* query_items,
                          QueryRequest* questions);

#endif
