// SPDX-License-Identifier: MIT
// mover_slide.h -- movers on their way through one call: what has happened to each, and the parts of its motion.
#ifndef MOVER_SLIDE_H
#define MOVER_SLIDE_H
#include "scree/scree.h"

typedef struct // one mover in a call
{
	scree_vec at;       // m: where it is
	scree_vec rest;     // m: what is left of its way
	scree_vec velocity; // m/s
	scree_vec carried;  // m: by its ground
	scree_vec way;      // m: by its velocity
	scree_vec last;     // normal of the surface that stopped it last, 0 for none
	scree_vec push;     // m: the part of its way that a wall took, 0 for none; asks for a climb
	scree_vec kept;     // m/s: its velocity before that
	scree_vec wall_normal, normal;
	scree_collidable wall, ground;
	bool crushed; // overlaps what it could not get out of: it stays where it was
	bool stood;   // on ground when the call began, and does not jump
} MoverMotion;

typedef struct // a call
{
	scree_world* world;
	const scree_mover_def* def;
	scree_query_def seen;
	scree_shape shape;
	scree_vec along; // unit vector at right angles to def->up
	float steepest;  // cosine of the steepest slope that is ground
	int count, asked;
	const scree_mover* movers;
	MoverMotion* motions;
	scree_probe* probes; // the asked ones, their answers, and which walkers they are of
	scree_ray* rays;
	scree_query_result* found;
	int* of;
	scree_body* bodies; // of the ground, and their poses
	scree_pose* poses;
} MoverCall;

static inline float dot(scree_vec a, scree_vec b) { return a.x * b.x + a.y * b.y; }
// a + s b
static inline scree_vec add_scaled(scree_vec a, float s, scree_vec b)
{
	return (scree_vec){a.x + s * b.x, a.y + s * b.y};
}

// The world ends at SCREE_MAX_COORDINATE: movers stop there.
scree_vec mover_within(scree_vec at);

// A walker is crushed by something: it stays where it was when the call began, out of what is static.
void mover_crush(const MoverCall* call, int k, scree_collidable by);

// Before anything moves: those that were crushed stay so while they overlap anything.
scree_status mover_is_crushed(MoverCall* call);

// Moves walkers out of what they overlap, until they keep their distance from everything or 8 rounds have passed. Those that overlap
// something then are crushed.
scree_status mover_recover(MoverCall* call);

// Moves them along what is left of their way. They slide along what they meet, and climb steps.
scree_status mover_slide(MoverCall* call);

// Finds the ground under those that have met none and do not rise, and sets those down on it that stood.
scree_status mover_stand(MoverCall* call);

#endif
