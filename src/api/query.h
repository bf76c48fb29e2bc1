// SPDX-License-Identifier: MIT
// query.h -- checks of queries, and what the device is asked.
#ifndef API_QUERY_H
#define API_QUERY_H
#include "step/queries.h"
#include "world/world.h"

// Checks what all queries have: the definition, and count items in two arrays.
scree_status query_check(scree_world* world, const char* function, const scree_query_def* def, const void* items,
                         const char* items_name, int count, Questions* questions);

// The shape of a query, null for a point, as the device takes it.
scree_status query_shape_of(const char* function, const char* argument, const scree_shape* shape, Attribute* to);

// The rays, or the probes with their shape, null for a point. moves: their translations need not be 0.
scree_status query_check_rays(scree_world* world, const char* function, const scree_ray* rays, Questions* questions);
scree_status query_check_probes(scree_world* world, const char* function, const scree_shape* shape,
                                const scree_probe* probes, bool moves, Questions* questions);

#endif
