// SPDX-License-Identifier: MIT
// bay_hash.h -- computes the hash of each world of a batch, which is that of the same world alone, and its counters.
#ifndef BAY_HASH_H
#define BAY_HASH_H
#include "stages/batch/bay_copy.h"
#include "stages/batch/bay_visit.h"
#include "stages/read/hash.h"

// Item: a world, by row. The terms are those of hash.h, with indices within the world. The constraints of a spare bay have
// no places, so the values that they keep are at their slots.
KERNEL(bay_hash)
{
	const Bays* bays = &p->step.bays;
	int at = p->world_bay[i], live = at < bays->worlds;
	Bay bay = p->bay[at];
	int bodies = bay_item(bays->worlds, at, 0, bays->bodies);
	int collidables = bay_item(bays->worlds, at, 0, bays->collidables);
	Origin origin;
	origin.body = live ? bodies : 0;
	origin.collidable = live ? collidables : 0;
	origin.attribute = bay.attribute;
	Word64 sum = 0;
	for (int k = 0; k < bay.bodies; ++k)
	{
		Word64 h = item_hash(p, PER_BODY, bodies + k, hash_begin(HASH_BODY, k), origin);
		sum += bay.sleep_threshold >= 0.0f ? hash_sleep(p, bodies + k, h) : h;
	}
	for (int k = 0; k < bay.collidables; ++k)
		if (p->collidable_kind[collidables + k] != KIND_DEAD)
			sum += item_hash(p, PER_COLLIDABLE, collidables + k, hash_begin(HASH_COLLIDABLE, k), origin);
#define CONSTRAINT_KIND(kind, Kind, KIND)                                  \
	for (int k = 0; k < 1 << bays->kind##_bits; ++k)                       \
	{                                                                      \
		int slot = bay_item(bays->worlds, at, k, 1 << bays->kind##_bits);  \
		Word64 h = kind##_hash_one(p, slot, k, origin);                    \
		if (!live && kind##_in_use(p, slot) && p->kind##_color[slot] >= 0) \
			h = kind##_hash_slot(h, p, slot);                              \
		sum += h;                                                          \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	p->bay_hash[i] = sum + visit_hash(p, at);
}

// Item: a world, by row.
KERNEL(bay_counters)
{
	const Bays* bays = &p->step.bays;
	int at = p->world_bay[i];
	BayState state = p->bay_state[at];
	BayCounters counters;
	counters.crowded = state.crowded;
	counters.nonfinite = state.nonfinite;
	counters.contacts = 0;
	counters.touching = 0;
	counters.asleep = 0;
	for (int k = 0; k < bays->bodies; ++k)
		counters.asleep += body_sleeps_on(p, bay_item(bays->worlds, at, k, bays->bodies));
	for (int k = 0; k < 1 << bays->contact_bits; ++k)
	{
		int slot = bay_item(bays->worlds, at, k, 1 << bays->contact_bits), used = contact_in_use(p, slot);
		counters.contacts += used;
		counters.touching += used && (p->contact_color[slot] >= 0 || p->contact_flags[slot] & CONTACT_ASLEEP);
	}
	counters.penetration = bits_float(state.penetration);
	counters.joint_gap = bits_float(state.joint_gap);
	p->bay_counters[i] = counters;
}

#endif
