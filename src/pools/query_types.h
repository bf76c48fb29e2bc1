// SPDX-License-Identifier: MIT
// query_types.h -- declares the data of queries and query results that device and user exchange.
#ifndef QUERY_TYPES_H
#define QUERY_TYPES_H
#include "pools/collidable_types.h"

// Types of queries, numbers of results per query, and sort orders of lists of results.
#define QUERY_RAYS    0
#define QUERY_SHAPES  1
#define QUERY_NEAREST 2
#define QUERY_SENSORS 3 // collidables that overlap sensors

#define QUERY_CLOSEST 0
#define QUERY_ANY     1 // at most one result, not always the nearest
#define QUERY_ALL     2

// Maximum number of results in a list. It is far below INT_MAX, because work-items increase the counter of results
// before they check it.
#define QUERY_MOST 1000000000

#define QUERY_BY_COLLIDABLE 0
#define QUERY_BY_FRACTION   1
#define QUERY_BY_QUERY      2

typedef struct // 32 bytes: a collidable as a leaf of the trees for queries
{
	float x, y, c, s; // world pose
	int attribute, body, collidable;
	Word kinds; // bit of the kind (bit 0 for KIND_STATIC) or, for a sensor, LEAF_SENSOR; also LEAF_LISTENS
} QueryLeaf;
// Bits of the argument of tree kernels. Bit 0 is the index of the tree.
#define TREE_QUERIES 2 // the kernel processes the tree's boxes for queries, not those of the step
#define TREE_PATHS   2 // same bit, for query_leaf: boxes enclose the motion of the step
#define TREE_STALE   4 // for query_leaf: boxes of the step are not valid, because poses have changed
#define LEAF_SENSOR  0x10u
#define LEAF_LISTENS 0x100u // neither category nor mask of the collidable is 0

typedef struct // 32 bytes: a query, with the same layout as scree_ray or scree_probe of the user
{
	Float4 a;                        // x, y: origin, m; z, w: path x, y of a ray, m, or rotation cos, sin of a probe
	Float2 b;                        // m: radius of a ray (x), or path x, y of a probe
	int ignored, ignored_generation; // index and generation of the body that the query ignores, 0 for none
} Query;

typedef struct // 32 bytes: scree_query_result on the device
{
	int collidable; // 1 + index, as in handles; 0 if nothing was found
	Word generation;
	float x, y, normal_x, normal_y;
	float fraction; // fraction of the path; for a query of the nearest collidable, its distance, m
	Word marks;     // FOUND_* bits
} QueryResult;
// The user reads the first two bytes of QueryResult.marks as bool.
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define FOUND_HIT    0x1000000u
#define FOUND_INSIDE 0x10000u
#else
#define FOUND_HIT    1u
#define FOUND_INSIDE 0x100u
#endif

typedef struct // settings that all queries of a call share
{
	Word64 category, mask;
	Word kinds;      // bits of QueryLeaf.kinds that the queries find
	int all;         // 1 if all bits of category and mask are set
	int room;        // capacity of the list of results
	int found;       // number of results found, including results beyond the capacity
	float most;      // m: maximum distance of the nearest collidable; one farther away is not found
	int skips;       // 1 to ignore each collidable inside which the query begins
	int rules;       // 1 to find one-way platforms from above only
	int bodies;      // number of used slots in the pool body_generation
	Attribute shape; // shape of the queries; a point for rays
} QueryPlan;

#endif
