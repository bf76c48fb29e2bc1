// SPDX-License-Identifier: MIT
// item.h -- what is done to an item in all its pools at once, by their roles: hashed, cleared, moved, fetched.
#ifndef ITEM_H
#define ITEM_H
#include "constraints/kinds.h"
#include "dialect/hash_word.h"
#include "pools/roles.h"

// Hashes of the types of hashed pools.
INLINE Word64 hash_int(Word64 h, int x) { return hash_word(h, (Word)x); }
INLINE Word64 hash_Word(Word64 h, Word x) { return hash_word(h, x); }
INLINE Word64 hash_Int2(Word64 h, Int2 v) { return hash_int(hash_int(h, v.x), v.y); }
INLINE Word64 hash_Float2(Word64 h, Float2 v) { return hash_float(hash_float(h, v.x), v.y); }
INLINE Word64 hash_Float4(Word64 h, Float4 v) { return hash_float4(h, v); }
INLINE Word64 hash_Filter(Word64 h, Filter v)
{
	h = hash_word(hash_word(h, (Word)v.category), (Word)(v.category >> 32));
	h = hash_word(hash_word(h, (Word)v.mask), (Word)(v.mask >> 32));
	return hash_int(h, v.group);
}
// not the motion within the step
INLINE Word64 hash_BodyState(Word64 h, BodyState v)
{
	h = hash_float(hash_float(hash_float(h, v.vx), v.vy), v.w);
	return hash_float(hash_float(h, v.inv_mass), v.inv_inertia);
}
INLINE Word64 hash_Motion(Word64 h, Motion v)
{
	h = hash_float(hash_float(hash_float(hash_float(h, v.fx), v.fy), v.torque), v.gravity_scale);
	return hash_float(hash_float(hash_float(hash_float(h, v.linear_damping), v.angular_damping), v.free_x), v.free_y);
}
// a body that is enabled has none
INLINE Word64 hash_StoredVelocity(Word64 h, StoredVelocity v)
{
	return v.stored != 0.0f ? hash_float4(h, make_float4(v.vx, v.vy, v.w, v.stored)) : h;
}
INLINE Word64 hash_LocalManifold(Word64 h, LocalManifold v)
{
	return hash_float4(hash_float4(hash_float4(hash_float4(h, v.normal), v.on_a), v.relative), v.then);
}

#define HASH_HASHED(x) x
#define HASH_STATE(x)
#define HASH_STANDING(x)
#define HASH_DERIVED(x)
#define HASH_SCRATCH(x)

// In all functions below per is a constant, so that the lines of other pools vanish.

INLINE Word64 item_hash(const Pools* p, Per per, int i, Word64 h)
{
#define X(type, name, of, role) HASH_##role(if (per == PER_##of) h = hash_##type(h, p->name[i]);)
#include "pools/pools.def"
#undef X
	return h;
}

// A new item: its maker writes what is not zero. {0} is no vector in OpenCL C, so the zero is what follows an explicit one.
INLINE void item_clear(const Pools* p, Per per, int i)
{
#define X(type, name, of, role)           \
	if (per == PER_##of && role <= STATE) \
	{                                     \
		const struct                      \
		{                                 \
			int first;                    \
			type zero;                    \
		} value = {0};                    \
		p->name[i] = value.zero;          \
	}
#include "pools/pools.def"
#undef X
}

// All that outlives a step.
INLINE void item_move(const Pools* p, Per per, int to, int from)
{
#define X(type, name, of, role)              \
	if (per == PER_##of && role <= STANDING) \
		p->name[to] = p->name[from];
#include "pools/pools.def"
#undef X
}

// Fetches what item_clear writes.
INLINE void item_fetch(const Pools* p, Per per, int i)
{
#define X(type, name, of, role)           \
	if (per == PER_##of && role <= STATE) \
		fetch_soon(p->name + i);
#include "pools/pools.def"
#undef X
	(void)p;
	(void)per;
	(void)i;
}

#endif
