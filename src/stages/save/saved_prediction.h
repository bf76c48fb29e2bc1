// SPDX-License-Identifier: MIT
// saved_prediction.h -- predicts values of contacts from the items of a save that are unpacked before them.
#ifndef SAVED_PREDICTION_H
#define SAVED_PREDICTION_H
#include "stages/narrow_phase/manifold_reuse.h"
#include "stages/save/saved_edges.h"

// Returns friction, restitution, rolling lever and tangent speed of two shapes, as contact_surface_of does.
OUT_OF_LINE void saved_surface(const Real a[8], const Real b[8], Real surface[4])
{
	Real friction = root(a[TRAIT_FRICTION] * b[TRAIT_FRICTION]), most = splat(MOST_FRICTION);
	surface[0] = blend(most, friction, friction < most);
	surface[1] = maximum(a[TRAIT_RESTITUTION], b[TRAIT_RESTITUTION]);
	surface[2] = maximum(a[TRAIT_ROLLING], b[TRAIT_ROLLING]) * maximum(a[TRAIT_RADIUS], b[TRAIT_RADIUS]);
	surface[3] = a[TRAIT_SPEED] + b[TRAIT_SPEED];
}

// Returns the index of the body of a collidable, 0 for none.
INLINE Int saved_body(const Pools* p, Int collidable)
{
	Int body = gather_int(p->collidable_body, collidable);
	return body & ~(body >> 31);
}

INLINE Int saved_same(Real a, Real b) { return real_bits(a) == real_bits(b); }

// m: Returns the motion up to which a manifold of two points, or none (`empty`), is kept, as narrow_phase_distance does
// for a gap of 0; -1 if `ahead`.
OUT_OF_LINE Real saved_limit(const Pools* p, Int ia, Int ib, const SavedEdges* e, Int empty, Int ahead)
{
	Real reach = minimum(e->at_a[TRAIT_REACH], e->at_b[TRAIT_REACH]);
	Real room = sweep_room(&p->step, gather_int(p->collidable_flags, ia) | gather_int(p->collidable_flags, ib));
	Real limit = blend(minimum(HOLD_DISTANCE * room, HOLD_SHARE * reach), STAY_DISTANCE * room, empty);
	return blend(limit, splat(-1.0f), ahead);
}

#define SAVED_TEST 7 // number of values of a test for points: pose of shape b, rotation of shape a, limit of the motion

// Sets `test` to the predicted pose of shape b in the frame of shape a, and to the rotation of shape a: those at the start of
// the step. saved_limit returns the limit.
OUT_OF_LINE void saved_pose(const Pools* p, Int ia, Int ib, Real test[SAVED_TEST])
{
	Real a[8], b[8];
	gather_fixed_rows8((GLOBAL float*)p->world_shape, ia, a);
	gather_fixed_rows8((GLOBAL float*)p->world_shape, ib, b);
	Vec axes = vec(a[2], a[3]);
	Vec position = vec_turn_back(axes, vec(b[0] - a[0], b[1] - a[1])), rotation = vec_turn_back(axes, vec(b[2], b[3]));
	test[0] = position.x;
	test[1] = position.y;
	test[2] = rotation.x;
	test[3] = rotation.y;
	test[4] = axes.x;
	test[5] = axes.y;
}

#endif
