// SPDX-License-Identifier: MIT
// hash.h -- computes the world hash: a sum of the hashes of all items, so that neither order nor padding matters.
#ifndef HASH_H
#define HASH_H
#include "constraints/contact_one.h"
#include "stages/edit/pool_item.h"

// Hashes the state of a body's sleep, in a world that sleeps.
INLINE Word64 hash_sleep(const Pools* p, int i, Word64 h)
{
	h = hash_int(hash_int(h, p->sleep[i]), body_mark(p, i));
	return hash_float(hash_float(h, p->still[i]), p->sleep_threshold[i]);
}

// Item: a partial sum of hashes, over the bodies i, i + HASH_SUMS, i + 2 HASH_SUMS and so on. argument: 1 if the world
// sleeps, and the number of bodies. This kernel writes the sums; the other kernels add to them.
KERNEL(hash_bodies)
{
	Word64 sum = 0;
	for (int k = i; k < RUN_HIGH(p->argument); k += HASH_SUMS)
	{
		Word64 h = item_hash(p, PER_BODY, k, hash_begin(HASH_BODY, k), origin_none());
		sum += RUN_LOW(p->argument) ? hash_sleep(p, k, h) : h;
	}
	p->hash[i] = sum;
}

KERNEL(hash_collidables)
{
	Word64 sum = 0;
	for (int k = i; k < p->argument; k += HASH_SUMS)
		if (p->collidable_kind[k] != KIND_DEAD)
			sum += item_hash(p, PER_COLLIDABLE, k, hash_begin(HASH_COLLIDABLE, k), origin_none());
	p->hash[i] += sum;
}

// Returns the hash of the constraint in slot i, 0 for a free slot. name: the slot, within its world.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                     \
	INLINE Word64 kind##_hash_one(const Pools* p, int i, int name, Origin origin)                             \
	{                                                                                                         \
		int place = p->kind##_place[i];                                                                       \
		if (!kind##_in_use(p, i))                                                                             \
			return 0;                                                                                         \
		Word64 h = item_hash(p, PER_##KIND, i, hash_begin(HASH_CONSTRAINT(CONSTRAINT_##KIND), name), origin); \
		if (place >= 0)                                                                                       \
			return kind##_hash_kept(h, p, place);                                                             \
		return p->kind##_flags[i] & (KIND##_ASLEEP) ? kind##_hash_slot(h, p, i) : h;                          \
	}                                                                                                         \
	KERNEL(kind##_hash)                                                                                       \
	{                                                                                                         \
		Word64 sum = 0;                                                                                       \
		for (int k = i; k < p->counters->kind##s; k += HASH_SUMS)                                             \
			sum += kind##_hash_one(p, k, k, origin_none());                                                   \
		p->hash[i] += sum;                                                                                    \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
