// SPDX-License-Identifier: MIT
// bay_hash.h -- computes the hash of each world of a batch, which is that of the same world alone.
#ifndef BAY_HASH_H
#define BAY_HASH_H
#include "stages/batch/bay_copy.h"
#include "stages/read/hash.h"

// Item: a live bay. The terms are those of hash.h, with indices within the world.
KERNEL(bay_hash)
{
	const Bays* bays = &p->step.bays;
	Bay bay = p->bay[i];
	Origin origin;
	origin.body = i * bays->bodies;
	origin.collidable = i * bays->collidables;
	origin.attribute = bay.attribute;
	Word64 sum = 0;
	for (int k = 0; k < bay.bodies; ++k)
		sum += item_hash(p, PER_BODY, origin.body + k, hash_begin(HASH_BODY, k), origin);
	for (int k = 0; k < bay.collidables; ++k)
		if (p->collidable_kind[origin.collidable + k] != KIND_DEAD)
			sum += item_hash(p, PER_COLLIDABLE, origin.collidable + k, hash_begin(HASH_COLLIDABLE, k), origin);
#define CONSTRAINT_KIND(kind, Kind, KIND)            \
	for (int k = 0; k < 1 << bays->kind##_bits; ++k) \
		sum += kind##_hash_one(p, (i << bays->kind##_bits) + k, k, origin);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	p->bay_hash[i] = sum;
}

#endif
