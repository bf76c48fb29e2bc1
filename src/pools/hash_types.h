// SPDX-License-Identifier: MIT
// hash_types.h -- defines the hash functions for the types of hashed pools.
#ifndef HASH_TYPES_H
#define HASH_TYPES_H
#include "dialect/hash_word.h"
#include "pools/pools.h"

typedef struct // first items of a world in the pools, other than 0 only in a batch
{
	int body, collidable, attribute;
} Origin;

INLINE Origin origin_none(void)
{
	Origin origin = {0, 0, 0};
	return origin;
}

INLINE Word64 hash_int(Word64 h, int x) { return hash_word(h, (Word)x); }
INLINE Word64 hash_Word(Word64 h, Word x) { return hash_word(h, x); }
INLINE Word64 hash_Int2(Word64 h, Int2 v) { return hash_int(hash_int(h, v.x), v.y); }
INLINE Word64 hash_Float2(Word64 h, Float2 v) { return hash_float(hash_float(h, v.x), v.y); }
INLINE Word64 hash_Float4(Word64 h, Float4 v) { return hash_float4(h, v); }
INLINE Word64 hash_Filter(Word64 h, Filter v)
{
	h = hash_word(hash_word(h, (Word)v.category), (Word)(v.category >> 32));
	h = hash_word(hash_word(h, (Word)v.mask), (Word)(v.mask >> 32));
	h = hash_int(h, v.group);
	return v.reports ? hash_word(h, v.reports) : h;
}
// Hashes a BodyState without dx, dy and da, the motion within the step.
INLINE Word64 hash_BodyState(Word64 h, BodyState v)
{
	h = hash_float(hash_float(hash_float(h, v.vx), v.vy), v.w);
	return hash_float(hash_float(h, v.inv_mass), v.inv_inertia);
}
INLINE Word64 hash_Motion(Word64 h, Motion v)
{
	h = hash_float(hash_float(hash_float(h, v.fx), v.fy), v.torque);
#define X(name, least, most, value) h = hash_float(h, v.name);
#include "pools/body_values.def"
	return hash_float(hash_float(h, v.free_x), v.free_y);
}
INLINE Word64 hash_StoredVelocity(Word64 h, StoredVelocity v)
{
	return v.stored != 0.0f ? hash_float4(h, make_float4(v.vx, v.vy, v.w, v.stored)) : h;
}
INLINE Word64 hash_LocalManifold(Word64 h, LocalManifold v)
{
	return hash_float4(hash_float4(hash_float4(hash_float4(h, v.normal), v.on_a), v.relative), v.then);
}

INLINE Word64 hash_JointFlags(Word64 h, JointFlags v) { return hash_int(h, v & ~JOINT_RECHAINED); }
INLINE Word64 hash_joint(Word64 h, JointData v, Origin origin)
{
	const float* numbers = &v.modes;
	h = hash_int(hash_int(h, v.body_a - origin.body), v.body_b - origin.body);
	for (int k = 0; k < 4 * JOINT_QUADS - 2; ++k)
		h = hash_float(h, numbers[k]);
	return h;
}

// Hash types with indices. The caller, item_hash, has the variable `origin`.
#define hash_BodyIndex(h, v)      hash_int(h, (v) < 0 ? (v) : (v)-origin.body)
#define hash_AttributeIndex(h, v) hash_int(h, (v) < 0 ? (v) : (v)-origin.attribute)
#define hash_CollidablePair(h, v) hash_int(hash_int(h, (v).x - origin.collidable), (v).y - origin.collidable)
#define hash_JointData(h, v)      hash_joint(h, v, origin)

#endif
