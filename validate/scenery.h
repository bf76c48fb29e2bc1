// SPDX-License-Identifier: MIT
// scenery.h -- makes a world of random collidables without bodies, and random probes that aim at them.
#ifndef SCENERY_H
#define SCENERY_H
#include "validate.h"

#define SCENERY_SHAPES 24
#define SCENERY_KINDS  5 // circles, capsules, segments, polygons and rounded polygons

typedef struct
{
	Validation* validation;
	scree_world* world;
	scree_shape shapes[SCENERY_SHAPES];
	scree_pose poses[SCENERY_SHAPES];
	scree_collidable handles[SCENERY_SHAPES];
	double place;    // m: the middle of the scenery is at (place, -place)
	double rounding; // m: rounding error of a coordinate at this place
} Scenery;

// Returns whether the engine of a validation is Scree. Queries of other engines have another interface.
bool scenery_is_of(const Validation* v);

Scenery scenery_open(Validation* v, uint64_t* seed, double place);
Scenery scenery_empty(Validation* v, double place); // opens a world without collidables
void scenery_close(Scenery* s);

// Prints the error of a failed call and ends the validation; does nothing if status is SCREE_OK.
void scenery_ok(const Scenery* s, scree_status status);

// Returns a random shape of a kind, with a size of 2 mm to 20 m. Many shapes are thin.
scree_shape scenery_shape(uint64_t* seed, int kind);

// Returns a random shape of any kind; all its points are at most 1 m from its origin
scree_shape scenery_small(uint64_t* seed);

// Returns a probe at a random pose in the scenery. Most translations pass through a random point of a shape of the
// scenery. Edges of probe and shape are often parallel.
scree_probe scenery_probe(const Scenery* s, uint64_t* seed, const scree_shape* shape);

// Returns a definition of queries that find collidables without bodies.
scree_query_def scenery_query_def(void);

// Returns true if a probe certainly misses shape k, by their bounding circles. reach: reach of the probe's shape, m.
bool scenery_is_away(const Scenery* s, int k, float reach, const scree_probe* probe);

#endif
