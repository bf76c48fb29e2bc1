// SPDX-License-Identifier: MIT
// own_queries.c -- keeps the results of queries that the library makes apart from those that the user reads.
#include "world/own_queries.h"

void own_queries_swap(scree_world* world)
{
	Queries queries = world->queries;
	world->queries = world->own_queries;
	world->own_queries = queries;
}
