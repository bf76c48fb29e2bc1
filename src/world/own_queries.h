// SPDX-License-Identifier: MIT
// own_queries.h -- keeps the results of queries that the library makes apart from those that the user reads.
#ifndef OWN_QUERIES_H
#define OWN_QUERIES_H
#include "world/world.h"

// Exchanges the query results of the user and those of the library. Called before and after a query of the library.
void own_queries_swap(scree_world* world);

#endif
