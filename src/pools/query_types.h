// SPDX-License-Identifier: MIT
// query_types.h -- queries and their answers, as the device and the user exchange them.
#ifndef QUERY_TYPES_H
#define QUERY_TYPES_H
#include "pools/collidable_types.h"

// Queries: their forms, the answers that they return, and the order of the answers.
#define QUERY_RAYS    0
#define QUERY_SHAPES  1
#define QUERY_NEAREST 2
#define QUERY_SENSORS 3 // overlaps of sensors

#define QUERY_CLOSEST 0
#define QUERY_ANY     1 // some answer, or none
#define QUERY_ALL     2

// Most answers of a list, far below the largest int: work-items add to the counter before they compare it with this.
#define QUERY_MOST 1000000000

#define QUERY_BY_COLLIDABLE 0
#define QUERY_BY_FRACTION   1
#define QUERY_BY_QUERY      2

typedef struct // 32 bytes: a collidable as a leaf of queries
{
	float x, y, c, s; // world pose
	int attribute, body, collidable;
	Word kinds; // bits: the kind, with KIND_STATIC at bit 0, or LEAF_SENSOR for a sensor; and LEAF_LISTENS
} QueryLeaf;
// Bits of the arguments of kernels of trees, whose bit 0 is the tree.
#define TREE_QUERIES 2 // the boxes for queries, not those of the step
#define TREE_PATHS   2 // query_leaf: boxes around the motion of the step
#define TREE_STALE   4 // query_leaf: the boxes of the step do not fit its poses
#define LEAF_SENSOR  0x10u
#define LEAF_LISTENS 0x100u // its category and mask are not 0

typedef struct // 32 bytes: a query as the user writes it: scree_ray, scree_probe
{
	Float4 a;                        // origin x, y; path x, y of a ray, else rotation cos, sin
	Float2 b;                        // radius of a ray, else path x, y; m
	int ignored, ignored_generation; // body that the query ignores, 0 for none
} Query;

typedef struct // 32 bytes: scree_query_result
{
	int collidable; // 1 + index, as in handles, 0 for none
	Word generation;
	float x, y, normal_x, normal_y;
	float fraction; // fraction of the path; for the nearest collidable, the distance, m
	Word marks;     // FOUND_* bits
} QueryResult;
#define FOUND_HIT    1u
#define FOUND_INSIDE 0x100u

typedef struct // settings that all queries of a call share
{
	Word64 category, mask;
	Word kinds;      // QueryLeaf.kinds that are found
	int all;         // 1 if category and mask have all bits
	int room;        // capacity of the lists of answers
	int found;       // answers found, including those beyond the capacity
	float most;      // m: greatest distance of a nearest collidable
	int skips;       // 1 to skip collidables inside which a query begins
	int rules;       // 1 to find one-way platforms from above only
	int bodies;      // used slots of the pool body_generation
	Attribute shape; // shape of the query; a point for rays
} QueryPlan;

#endif
