// SPDX-License-Identifier: MIT
// mover_slide.h -- the state of movers during one call, and the parts of their motion.
#ifndef MOVER_SLIDE_H
#define MOVER_SLIDE_H
#include "scree/scree.h"

typedef struct // one mover in a call
{
	scree_vec at;       // m: current position
	scree_vec rest;     // m: remaining motion
	scree_vec velocity; // m/s
	scree_vec carried;  // m: motion by its ground
	scree_vec way;      // m: motion by its velocity
	scree_vec last;     // normal of the surface that stopped it last, 0 for none
	scree_vec push;     // m: motion that a wall stopped, 0 for none; if set, a climb is tried
	scree_vec kept;     // m/s: its velocity before the wall
	scree_vec wall_normal, normal;
	scree_collidable wall, ground;
	bool crushed; // it overlaps a surface and could not get out, so it stays at its old position
	bool stood;   // it was on ground at the beginning of the call, and does not jump
} MoverMotion;

typedef struct // a call
{
	scree_world* world;
	const scree_mover_def* def;
	scree_query_def seen;
	scree_shape shape;
	scree_vec along; // unit vector perpendicular to def->up
	float steepest;  // cosine of the steepest slope that counts as ground
	int count, asked;
	const scree_mover* movers;
	MoverMotion* motions;
	scree_probe* probes; // current probes, their answers, and the mover of each
	scree_ray* rays;
	scree_query_result* found;
	int* of;
	scree_body* bodies; // bodies of the ground, and their poses
	scree_pose* poses;
} MoverCall;

static inline float dot(scree_vec a, scree_vec b) { return a.x * b.x + a.y * b.y; }
static inline scree_vec add_scaled(scree_vec a, float s, scree_vec b)
{
	return (scree_vec){a.x + s * b.x, a.y + s * b.y};
}

// Clamps a position to SCREE_MAX_COORDINATE, the edge of the world.
scree_vec mover_within(scree_vec at);

// Marks a mover as crushed: it stays where it was at the beginning of the call, outside of static shapes.
void mover_crush(const MoverCall* call, int k, scree_collidable by);

// Checks the movers that were crushed before: they remain so while they overlap anything. Called before anything moves.
scree_status mover_is_crushed(MoverCall* call);

// Moves movers out of overlaps, to their distance, in at most 8 rounds; those that still overlap are crushed.
scree_status mover_recover(MoverCall* call);

// Moves movers by their remaining motion. They slide along surfaces and climb steps.
scree_status mover_slide(MoverCall* call);

// Finds the ground below movers that have met none and do not rise, and sets those down on it that stood before.
scree_status mover_stand(MoverCall* call);

#endif
