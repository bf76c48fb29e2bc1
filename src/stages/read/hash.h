// SPDX-License-Identifier: MIT
// hash.h -- computes the world hash: a sum of the hashes of all items, so that neither order nor padding matters.
#ifndef HASH_H
#define HASH_H
#include "constraints/contact_one.h"
#include "stages/edit/pool_item.h"

// Item: a partial sum of hashes, over the bodies i, i + HASH_SUMS, i + 2 HASH_SUMS and so on. argument: number of
// bodies. This kernel writes the sums; the other kernels add to them.
KERNEL(hash_bodies)
{
	Word64 sum = 0;
	for (int k = i; k < p->argument; k += HASH_SUMS)
		sum += item_hash(p, PER_BODY, k, hash_begin(HASH_BODY, k));
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
			sum += place >= 0 ? kind##_hash_kept(h, p, place) : h;                                     \
		}                                                                                              \
		p->hash[i] += sum;                                                                             \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
