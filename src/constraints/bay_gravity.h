// SPDX-License-Identifier: MIT
// bay_gravity.h -- returns values that may differ between the worlds of a batch: gravity, and lengths of the last substep.
//
// If all worlds of a batch have the same values, or outside of a batch, they are those of Step. Functions for several lanes
// gather the values of the world of each lane.
#ifndef BAY_GRAVITY_H
#define BAY_GRAVITY_H
#include "dialect/vec.h"
#include "pools/bays.h"

// Returns whether the worlds of a batch have different gravity.
#ifdef SCREE_NO_BATCHES
#define GRAVITY_VARIES(p) ((void)(p), 0)
#else
#define GRAVITY_VARIES(p) ((p)->step.bays.varied)
#endif

// Returns member `name` of the rows `index` of a pool, one per lane.
#define BAY_FLOATS(pool, name, index) \
	gather((const GLOBAL float*)&(pool)->name, (index) * (int)(sizeof *(pool) / sizeof(float)))
#define BAY_INTS(pool, name, index) \
	gather_int((const GLOBAL int*)&(pool)->name, (index) * (int)(sizeof *(pool) / sizeof(int)))

// Returns the bays of bodies; the last one for the padding behind the bodies of the worlds.
INLINE Int bays_of_bodies(const Pools* p, Int body)
{
	int size = p->step.bays.bodies, last = p->step.bays.worlds - 1;
	Int bay = whole(real_of(body) * p->step.bays.body_part), rest = body - bay * size; // as in bay_of
	bay = blend_int(blend_int(bay, bay + 1, rest >= size), bay - 1, rest < 0);
	return blend_int(bay, 0 * bay + last, bay > last);
}

// Returns the bays of the slots of constraints; the first one for padding, whose slot is -1.
INLINE Int bays_of_slots(Int slot, int bits) { return blend_int(slot >> bits, 0 * slot, slot < 0); }

// Returns the rows of the worlds in bays; the first one for the padding behind the bodies of the live bays.
INLINE Int rows_of_bays(const Pools* p, Int bay)
{
	Int row = BAY_INTS(p->bay, world, bay);
	return blend_int(row, 0 * row, row < 0);
}

// Returns the gravity of the worlds of bodies, m/s^2, if worlds differ in it.
RARE Vec gravity_varied(const Pools* p, Int body)
{
	Int row = rows_of_bays(p, bays_of_bodies(p, body));
	return vec(BAY_FLOATS(p->bay_gravity, x, row), BAY_FLOATS(p->bay_gravity, y, row));
}

INLINE Vec gravity_of(const Pools* p, Int body)
{
	if (GRAVITY_VARIES(p))
		return gravity_varied(p, body);
	return vec(splat(p->step.gravity_x), splat(p->step.gravity_y));
}

// Returns the values of the world of a body, if worlds differ in gravity.
INLINE const GLOBAL BayGravity* gravity_row(const Pools* p, int body)
{
	return p->bay_gravity + p->bay[bay_of_body(p, body)].world;
}

// Return the gravity of the world of one body, m/s^2, and Step.fall of this world, m.
INLINE float gravity_x_of(const Pools* p, int body)
{
	return GRAVITY_VARIES(p) ? gravity_row(p, body)->x : p->step.gravity_x;
}
INLINE float gravity_y_of(const Pools* p, int body)
{
	return GRAVITY_VARIES(p) ? gravity_row(p, body)->y : p->step.gravity_y;
}
INLINE float fall_of(const Pools* p, int body) { return GRAVITY_VARIES(p) ? gravity_row(p, body)->fall : p->step.fall; }

// Returns Step.calm of the world of a body, as it is alone.
INLINE int bay_calm(const Pools* p, int body)
{
	if (!BATCHED(p))
		return p->step.calm;
	const GLOBAL Bay* bay = p->bay + bay_of_body(p, body);
	return (GRAVITY_VARIES(p) ? p->bay_gravity[bay->world].calm : p->step.calm) && bay->joints == 0 && bay->fields == 0;
}

// m: Returns Softness.depth of the contacts at places i to i + LANES - 1. fixed: mask of contacts of which one body cannot
// move.
RARE Real depth_varied(const Pools* p, int i, Int fixed)
{
	Int bay = bays_of_slots(load_int(p->contact_place_slot, i), p->step.bays.contact_bits);
	Int row = rows_of_bays(p, bay);
	return blend(BAY_FLOATS(p->bay_gravity, pair_depth, row), BAY_FLOATS(p->bay_gravity, fixed_depth, row), fixed);
}

INLINE Real depth_of(const Pools* p, int i, Int fixed)
{
	if (GRAVITY_VARIES(p))
		return depth_varied(p, i, fixed);
	return blend(splat(p->step.pair.depth), splat(p->step.fixed.depth), fixed);
}

// Returns Step.h_ratio of the worlds of the joints at places i to i + LANES - 1.
RARE Real h_ratio_varied(const Pools* p, int i)
{
	Int bay = bays_of_slots(load_int(p->joint_place_slot, i), p->step.bays.joint_bits);
	return BAY_FLOATS(p->bay_state, h_ratio, bay);
}

INLINE Real h_ratio_of(const Pools* p, int i)
{
	return BATCHED(p) && p->step.h_ratio == 0.0f ? h_ratio_varied(p, i) : splat(p->step.h_ratio);
}

// The same for one joint.
INLINE float h_ratio_at(const Pools* p, int slot)
{
	return BATCHED(p) && p->step.h_ratio == 0.0f ? bay_of_joint(p, slot)->h_ratio : p->step.h_ratio;
}

// Sets BayState.h_ratio in a step with dt above 0.
INLINE void bay_set_ratio(const Pools* p, GLOBAL BayState* state)
{
	state->h_ratio = state->substep > 0.0f ? quotient(p->step.h, state->substep) : 1.0f;
}

#endif
