// SPDX-License-Identifier: MIT
// mix.h -- mixes whole numbers, for hashes, for the digest of a packet and for random numbers.
#ifndef MIX_H
#define MIX_H
#include <stdint.h>

// Returns a hash of a hash and a value. It is one to one in each of the two, so that a change of one value always changes the
// result.
static inline uint64_t mix(uint64_t hash, uint64_t value)
{
	hash = (hash ^ value) * 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio, odd
	return hash ^ hash >> 29;
}

// Returns a random number below count, and changes the seed.
static inline uint32_t mix_below(uint64_t* seed, uint32_t count)
{
	*seed = mix(*seed, 1) + 1;
	return (uint32_t)((mix(*seed, 0) >> 32) * count >> 32);
}

#endif
