// SPDX-License-Identifier: MIT
// hash_word.h -- hashes items, in kernels and on the host.
#ifndef HASH_WORD_H
#define HASH_WORD_H
#include "dialect/dialect.h"

// Finalizer of MurmurHash3 (Austin Appleby, 2011): each input bit changes half of the output bits on average.
INLINE Word64 hash_mix(Word64 h)
{
	h ^= h >> 33;
	h *= (Word64)0xff51afd7ed558ccdUL;
	h ^= h >> 33;
	h *= (Word64)0xc4ceb9fe1a85ec53UL;
	h ^= h >> 33;
	return h;
}

INLINE Word64 hash_word(Word64 h, Word x) { return hash_mix(h + (Word64)0x9e3779b97f4a7c15UL + (Word64)x); }
INLINE Word64 hash_float(Word64 h, float x) { return hash_word(h, float_word(x)); }
INLINE Word64 hash_float4(Word64 h, Float4 v)
{
	return hash_float(hash_float(hash_float(hash_float(h, v.x), v.y), v.z), v.w);
}
// Tags that distinguish items of different kinds with the same index.
#define HASH_BODY                1
#define HASH_COLLIDABLE          2
#define HASH_TARGET              4
#define HASH_DISABLED            5
#define HASH_DISABLED_COLLIDABLE 6
#define HASH_PATH                7
#define HASH_VISIT               8
#define HASH_MATERIALS           9
#define HASH_EXCLUDED            10
#define HASH_ALLOWED             12
#define HASH_FIELD               13
#define HASH_OWN_MASS            14
#define HASH_CONSTRAINT(kind)    (3 + 8 * (kind))
INLINE Word64 hash_begin(int tag, int item) { return hash_word(hash_word((Word64)0, (Word)tag), (Word)item); }

#endif
