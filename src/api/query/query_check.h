// SPDX-License-Identifier: MIT
// query_check.h -- checks queries, and converts them for the device.
#ifndef QUERY_CHECK_H
#define QUERY_CHECK_H
#include "step/step_queries.h"
#include "world/check.h"
#include "world/world.h"

typedef struct // rays or probes of a call, and the values that their check needs
{
	const scree_world* world;
	const char* function;
	const void* items;
	float longest; // m: largest absolute value of a component of a translation
} QueryItems;

scree_status check_query_kinds(ArgumentPlace at, uint32_t kinds);

// Checks a definition and the array of its items, and initializes *query_items and *questions; the values of the items
// are checked later. *query_items must outlive *questions.
scree_status query_check(scree_world* world, const char* function, const scree_query_def* def, const void* items,
                         const char* items_name, int count, QueryItems* query_items, QueryRequest* questions);

// Checks the shape of a query, null for a point, and converts it for the device.
scree_status query_shape_of(const char* function, const char* argument, const scree_shape* shape, Attribute* to);

// Set *questions to rays, or to probes with a shape (null: a point). query_probes checks the shape.
void query_rays(QueryItems* query_items, QueryRequest* questions);
scree_status query_probes(scree_world* world, const scree_shape* shape, QueryItems* query_items,
                          QueryRequest* questions);

#endif
