// SPDX-License-Identifier: MIT
// hash.h -- the world hash: a sum of a hash of each item, so that neither order nor padding matters.
#ifndef HASH_H
#define HASH_H
#include "constraints/contact_one.h"
#include "constraints/kinds.h"
#include "dialect/hash_word.h"

// What is kept of a constraint, in the order of its rows.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                            \
	INLINE Word64 kind##_hash_kept(Word64 h, const Pools* p, int i)                  \
	{                                                                                \
		int lane = i % MAX_LANES;                                                    \
		{                                                                            \
			const GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES;          \
			KIND##_ROWS(ROW_HASH)                                                    \
		}                                                                            \
		{                                                                            \
			const GLOBAL Kind##RareRows* rows = p->kind##_rare_rows + i / MAX_LANES; \
			KIND##_RARE_ROWS(ROW_HASH)                                               \
		}                                                                            \
		return h;                                                                    \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// Item i sums items i, i + HASH_SUMS, ... below argument. hash_bodies starts the sums, the other stages add to them.
STAGE(hash_bodies)
{
	Word64 sum = 0;
	for (int k = i; k < p->argument; k += HASH_SUMS)
	{
		BodyState body = p->body[k];
		Motion motion = p->motion[k];
		Word64 h = hash_float4(hash_begin(1, k), p->pose[k]);
		h = hash_float(hash_float(hash_float(hash_float(hash_float(h, body.vx), body.vy), body.w), body.inv_mass),
		               body.inv_inertia);
		h = hash_float(hash_float(hash_float(hash_float(h, motion.fx), motion.fy), motion.torque),
		               motion.gravity_scale);
		h = hash_float(
		    hash_float(hash_float(hash_float(h, motion.linear_damping), motion.angular_damping), motion.free_x),
		    motion.free_y);
		h = hash_float(hash_float(h, p->pose_low[k].x), p->pose_low[k].y);
		h = hash_float(hash_float(h, p->local_center[k].x), p->local_center[k].y);
		Float4 kept = p->kept[k];
		sum += kept.w != 0.0f ? hash_float4(h, kept) : h;
	}
	p->hash[i] = sum;
}

STAGE(hash_collidables)
{
	Word64 sum = 0;
	for (int k = i; k < p->argument; k += HASH_SUMS)
	{
		int kind = p->collidable_kind[k];
		if (kind == KIND_DEAD)
			continue;
		Filter filter = p->filter[k];
		Word64 h = hash_word(hash_word(hash_word(hash_begin(2, k), (Word)kind), (Word)p->collidable_body[k]),
		                     (Word)p->collidable_attribute[k]);
		h = hash_float4(hash_float4(h, p->collidable_pose[k]), p->box[k]);
		h = hash_word(hash_word(h, (Word)filter.category), (Word)(filter.category >> 32));
		h = hash_word(hash_word(h, (Word)filter.mask), (Word)(filter.mask >> 32));
		sum += hash_word(h, (Word)filter.group);
	}
	p->hash[i] += sum;
}

// Constraints: what their kind hashes of an item, then what is kept of it.
#define CONSTRAINT_KIND(kind, Kind, KIND)                              \
	STAGE(kind##_hash)                                                 \
	{                                                                  \
		Word64 sum = 0;                                                \
		for (int k = i; k < p->counters->kind##s; k += HASH_SUMS)      \
		{                                                              \
			Word64 h = 0;                                              \
			int place = p->kind##_place[k];                            \
			if (kind##_hash_fields(p, k, &h))                          \
				sum += place >= 0 ? kind##_hash_kept(h, p, place) : h; \
		}                                                              \
		p->hash[i] += sum;                                             \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
