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
		Word64 h = item_hash(p, PER_BODY, k, hash_begin(HASH_BODY, k));
		sum += RUN_LOW(p->argument) ? hash_sleep(p, k, h) : h;
	}
	p->hash[i] = sum;
}

KERNEL(hash_collidables)
{
	Word64 sum = 0;
	for (int k = i; k < p->argument; k += HASH_SUMS)
		if (p->collidable_kind[k] != KIND_DEAD)
			sum += item_hash(p, PER_COLLIDABLE, k, hash_begin(HASH_COLLIDABLE, k));
	p->hash[i] += sum;
}

#define CONSTRAINT_KIND(kind, Kind, KIND)                                                              \
	KERNEL(kind##_hash)                                                                                \
	{                                                                                                  \
		Word64 sum = 0;                                                                                \
		for (int k = i; k < p->counters->kind##s; k += HASH_SUMS)                                      \
		{                                                                                              \
			if (!kind##_in_use(p, k))                                                                  \
				continue;                                                                              \
			Word64 h = item_hash(p, PER_##KIND, k, hash_begin(HASH_CONSTRAINT(CONSTRAINT_##KIND), k)); \
			int place = p->kind##_place[k];                                                            \
			if (place >= 0)                                                                            \
				h = kind##_hash_kept(h, p, place);                                                     \
			else if (p->kind##_flags[k] & (KIND##_ASLEEP))                                             \
				h = kind##_hash_slot(h, p, k);                                                         \
			sum += h;                                                                                  \
		}                                                                                              \
		p->hash[i] += sum;                                                                             \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
