// SPDX-License-Identifier: MIT
// hash.h -- the world hash: a sum over items of a hash of each, so that no order and no padding matters.
#ifndef HASH_H
#define HASH_H
#include "constraints/kinds.h"
#include "stages/hash_word.h"

// What is kept of a constraint, in the order of its rows.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                            \
	INLINE Word64 kind##_hash(Word64 h, const Pools* p, int i)                       \
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

// Item i sums items i, i + HASH_SUMS, ... below argument. hash_bodies begins the sums, the others add to them.
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

STAGE(hash_contacts)
{
	Word64 sum = 0;
	for (int k = i; k < p->counters->contacts; k += HASH_SUMS)
	{
		Int2 pair = p->pair[k], feature = p->contact_feature[k];
		if (pair.x < 0)
			continue;
		Word64 h = hash_word(hash_word(hash_begin(3, k), (Word)pair.x), (Word)pair.y);
		h = hash_word(hash_word(h, p->contact_flags[k]), (Word)p->contact_color[k]);
		h = hash_word(hash_word(h, (Word)feature.x), (Word)feature.y);
		Found found = p->contact_found[k];
		h = hash_float4(hash_float4(h, found.normal), found.on_a);
		h = hash_float4(hash_float4(h, found.relative), found.then);
		h = hash_float4(h, p->contact_surface[k]);
		int c = p->contact_place[k];
		if (c >= 0)
			h = contact_hash(h, p, c);
		sum += h;
	}
	p->hash[i] += sum;
}

#endif
