// SPDX-License-Identifier: MIT
// bays.h -- returns the bays of items: in the pools of a batch, each world has a bay, a range of items of each kind.
//
// All bays of a kind have the same number of items, so the bay of an item follows from its index. The bits of a world
// depend only on indices within its bay. Outside of a batch all members of Bays are 0, and every item is in bay 0.
#ifndef BAYS_H
#define BAYS_H
#include "pools/pools.h"

// Returns whether the pools contain the worlds of a batch. The engine that a page downloads first has no batches, and neither has
// the OpenCL program of a world alone.
#if defined(SCREE_NO_BATCHES) || defined(WORLD_ALONE)
#define BATCHED(p) ((void)(p), 0)
#else
#define BATCHED(p) ((p)->step.bays.worlds != 0)
#endif

// Returns i divided by `size`. part: 1 / size. An index below 2^24 is exact as a float, so the rounded product is off by at
// most one.
INLINE int bay_of(int i, int size, float part)
{
	int bay = (int)((float)i * part), rest = i - bay * size;
	return bay + (rest >= size) - (rest < 0);
}

INLINE int bay_of_body(const Pools* p, int i)
{
	return BATCHED(p) ? bay_of(i, p->step.bays.bodies, p->step.bays.body_part) : 0;
}

INLINE int bay_of_collidable(const Pools* p, int i)
{
	return BATCHED(p) ? bay_of(i, p->step.bays.collidables, p->step.bays.collidable_part) : 0;
}

// Returns the first item of the spare bays, of a kind whose bays have `size` items: the first whole group behind the
// worlds, because wide kernels also process the padding behind the last world.
INLINE int bay_spare(int worlds, int size) { return (worlds * size + GROUP_ITEMS - 1) / GROUP_ITEMS * GROUP_ITEMS; }

// Returns the first body of the bay of body i, which may be spare.
INLINE int bay_first_body(const Pools* p, int i)
{
	int size = p->step.bays.bodies, spare;
	if (!BATCHED(p))
		return 0;
	spare = bay_spare(p->step.bays.worlds, size);
	return i < spare ? bay_of_body(p, i) * size : spare + bay_of(i - spare, size, p->step.bays.body_part) * size;
}

// Returns item k of a bay of a kind whose bays have `size` items.
INLINE int bay_item(int worlds, int bay, int k, int size)
{
	return (bay < worlds ? bay * size : bay_spare(worlds, size) + (bay - worlds) * size) + k;
}

// Returns the number of items of bay_copy_item for a number of items of a kind: work-items of a GPU that run together then have one
// kind.
INLINE int bay_copy_whole(int items) { return (items + 31) & ~31; }

// Returns the ground, the motionless body of a world, for a collidable without a body.
INLINE int bay_ground(const Pools* p, int collidable)
{
	return BATCHED(p) ? bay_of_collidable(p, collidable) * p->step.bays.bodies : 0;
}

// Returns the index of a body within its bay.
INLINE int bay_body(const Pools* p, int i) { return BATCHED(p) ? i - bay_of_body(p, i) * p->step.bays.bodies : i; }

// Returns whether the world of a body has joints.
INLINE int bay_has_joints(const Pools* p, int body)
{
	return BATCHED(p) ? p->bay[bay_of_body(p, body)].joints : p->step.joints;
}

// m/s: Returns the sleep threshold of the world of a body, in a step with sleep; below 0 if the world does not sleep.
INLINE float bay_sleep_threshold(const Pools* p, int body)
{
	return BATCHED(p) ? p->bay[bay_of_body(p, body)].sleep_threshold : p->step.sleep_threshold;
}

// Returns the first path sample of the world of a joint.
INLINE int bay_path(const Pools* p, int slot)
{
	return BATCHED(p) ? p->bay[slot >> p->step.bays.joint_bits].path_sample : 0;
}

// Return the state of the world of a body, of a contact slot or of a joint slot, in a batch.
INLINE GLOBAL BayState* bay_state_of(const Pools* p, int body) { return p->bay_state + bay_of_body(p, body); }
INLINE GLOBAL BayState* bay_of_contact(const Pools* p, int slot)
{
	return p->bay_state + (slot >> p->step.bays.contact_bits);
}
INLINE GLOBAL BayState* bay_of_joint(const Pools* p, int slot)
{
	return p->bay_state + (slot >> p->step.bays.joint_bits);
}

// Returns whether this step searches the islands of the world of a body, if it searches any.
INLINE int bay_searches(const Pools* p, int body) { return !BATCHED(p) || bay_state_of(p, body)->searches; }

// Return the number of words of the bits of a sensor, one bit for each collidable of a bay; and of a bay in the pool
// bay_visit, where the bits of all sensors follow their list.
INLINE int visit_words(int collidables) { return (collidables + 31) / 32; }
INLINE int visit_size(int sensors, int collidables) { return sensors * (1 + visit_words(collidables)); }

// Entry of the list of sensors of a bay, for no sensor.
#define VISIT_NONE 0xffffffffu

// Bits of the argument of bay_count: worlds may have joints; joints got other spots; excluded pairs changed.
#define BAY_COUNT_JOINTS   1
#define BAY_COUNT_SPOTS    2
#define BAY_COUNT_EXCLUDED 4

// Number of words of a BayState, the distance between equal members of adjacent bays.
#define BAY_WORDS ((int)(sizeof(BayState) / sizeof(int)))

#endif
