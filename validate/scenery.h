// SPDX-License-Identifier: MIT
// scenery.h -- a world of random collidables without bodies, and random probes that aim at them.
#ifndef SCENERY_H
#define SCENERY_H
#include "validate.h"

#define SCENERY_SHAPES 24
#define SCENERY_KINDS  5 // circles, capsules, segments, polygons, rounded polygons

typedef struct
{
	Validation* validation;
	scree_world* world;
	scree_shape shapes[SCENERY_SHAPES];
	scree_pose poses[SCENERY_SHAPES];
	scree_collidable handles[SCENERY_SHAPES];
	double place;    // m: x and -y of its middle
	double rounding; // m: of a coordinate there
} Scenery;

// Whether the engine of a validation is Scree: the queries of another one have another interface.
bool scenery_is_of(const Validation* v);

Scenery scenery_open(Validation* v, uint64_t* seed, double place);
Scenery scenery_empty(Validation* v, double place); // a world without collidables
void scenery_close(Scenery* s);

// Prints the error of a call, and breaks the validation.
void scenery_ok(const Scenery* s, scree_status status);

// A shape of a kind, of 2 mm to 20 m, many of them thin.
scree_shape scenery_shape(uint64_t* seed, int kind);

scree_shape scenery_small(uint64_t* seed); // a shape of any kind, with all points at most 1 m from its origin

// A place in the scenery, with a translation to a random point of one of its shapes and beyond; edges are often parallel.
scree_probe scenery_probe(const Scenery* s, uint64_t* seed, const scree_shape* shape);

// Collidables without bodies are seen.
scree_query_def scenery_query_def(void);

// Whether a probe, whose shape has a reach, passes shape k at a distance. False when in doubt.
bool scenery_is_away(const Scenery* s, int k, float reach, const scree_probe* probe);

#endif
