// SPDX-License-Identifier: MIT
// mover_slide.h -- declares the state of movers during one call, and the parts of their motion.
#ifndef MOVER_SLIDE_H
#define MOVER_SLIDE_H
#include "scree/scree.h"

typedef struct // one mover in a call
{
	scree_vec at;       // m: current position
	scree_vec rest;     // m: remaining motion
	scree_vec velocity; // m/s
	scree_vec carried;  // m: motion by the ground on which the mover stands
	scree_vec way;      // m: motion by the velocity of the mover
	scree_vec last;     // normal of the last surface that stopped the mover, 0 for none
	scree_vec push;     // m: motion that a wall stopped; the mover then tries to climb a step; 0 for none
	scree_vec kept;     // m/s: velocity before the mover met the wall
	scree_vec wall_normal, normal;
	scree_collidable wall, ground;
	bool crushed; // the mover overlaps a surface and could not get out, so it stays at its old position
	bool stood;   // the mover was on ground at the beginning of the call, and does not jump
} MoverMotion;

typedef struct // a call of scree_movers_move
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
	scree_probe* probes; // current probes; their results are in `found`, the indices of their movers in `of`
	scree_ray* rays;
	scree_query_result* found;
	int* of;
	scree_body* bodies; // bodies on which movers stand; their poses are in `poses`
	scree_pose* poses;
} MoverCall;

static inline float dot(scree_vec a, scree_vec b) { return a.x * b.x + a.y * b.y; }
static inline scree_vec add_scaled(scree_vec a, float s, scree_vec b)
{
	return (scree_vec){a.x + s * b.x, a.y + s * b.y};
}

// Clamps both coordinates of a position to the range of the world, up to SCREE_MAX_COORDINATE in each direction.
scree_vec mover_within(scree_vec at);

// Marks mover k as crushed by a collidable, and moves the mover back to its position at the beginning of the call.
void mover_crush(const MoverCall* call, int k, scree_collidable by);

// Clears the mark of crushed movers that no longer overlap a surface. Called before any mover moves.
scree_status mover_is_crushed(MoverCall* call);

// Moves movers away from surfaces nearer than the skin. Movers that overlap a surface in the last round (8) are
// crushed.
scree_status mover_recover(MoverCall* call);

// Moves movers by their remaining motion; they slide along surfaces and climb steps.
scree_status mover_slide(MoverCall* call);

// Moves movers down to ground if they touched no ground in this call and do not rise. The ground may be 2 skin below
// them, or 2 skin + snap_distance for movers that stood on ground before.
scree_status mover_stand(MoverCall* call);

#endif
