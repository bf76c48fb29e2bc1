// SPDX-License-Identifier: MIT
// query_types.h -- what queries ask, and what they answer, as the device and the user have it.
#ifndef QUERY_TYPES_H
#define QUERY_TYPES_H
#include "dialect/dialect.h"

// Queries: what is asked, of which answers, and in what order they are sorted.
#define QUERY_RAYS    0
#define QUERY_SHAPES  1
#define QUERY_NEAREST 2
#define QUERY_SENSORS 3 // visits of sensors

#define QUERY_CLOSEST 0
#define QUERY_ANY     1 // only whether there is one
#define QUERY_ALL     2

// the most answers that a list may have. Work-items add to their counter before they see that it is beyond: it must not exceed an int
#define QUERY_MOST 1000000000

#define QUERY_BY_COLLIDABLE 0
#define QUERY_BY_FRACTION   1
#define QUERY_BY_QUERY      2

typedef struct // 32 bytes: a collidable as queries see it
{
	float x, y, c, s; // world pose
	int attribute, body, collidable;
	Word kinds; // a bit for its kind, KIND_STATIC first, or of a sensor that for sensors; and more
} QueryLeaf;
#define LEAF_SENSOR  0x10u
#define LEAF_LISTENS 0x100u // its category and mask are not 0

typedef struct // 32 bytes: a query as the user writes it: scree_ray, scree_probe
{
	Float4 a;                        // origin x, y; path x, y of a ray, else rotation cos, sin
	Float2 b;                        // radius of a ray, else path x, y; m
	int ignored, ignored_generation; // body that it does not see, 0 for none
} Query;

typedef struct // 32 bytes: scree_query_result
{
	int collidable; // as in handles: 1 + index, 0 for none
	Word generation;
	float x, y, normal_x, normal_y;
	float fraction; // of the path; of the nearest, the distance in m
	Word marks;     // FOUND_* bits
} QueryResult;
#define FOUND_HIT    1u
#define FOUND_INSIDE 0x100u

typedef struct // 32 bytes: a body that moved, as the user is told
{
	Float4 pose; // of the center of mass: x, y, cos, sin
	float vx, vy, w;
	int body;
} MovedBody;

#endif
