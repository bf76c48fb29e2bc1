// SPDX-License-Identifier: MIT
// random_queries.h -- creates random shapes, poses and queries.
#ifndef RANDOM_QUERIES_H
#define RANDOM_QUERIES_H
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"

scree_shape random_shape(uint64_t* seed, float scale);
// Returns a random pose in a square. size: half of the side of the square.
scree_pose random_pose(uint64_t* seed, scree_vec center, float size);
scree_vec random_path(uint64_t* seed, float size);
scree_query_def random_def(uint64_t* seed);

#endif
