// SPDX-License-Identifier: MIT
// transform_grain.h -- computes the flags of thin collidables, which have smaller tolerances.
#ifndef TRANSFORM_GRAIN_H
#define TRANSFORM_GRAIN_H
#include "dialect/dialect.h"
#include "pools/collidable_types.h"

#define REACH_SHARE 0.125f // factor of the reach before it is compared with the same sizes as the thickness

// Returns a mask: the bit of a level is set if 2^level times `length` is below GRAIN_SIZE / 2. length: m, from the
// center of a shape; first: bit of level 0.
INLINE Int transform_bits(Real length, int first)
{
	Int bits = 0 * real_bits(length);
	for (int level = 0; level < GRAIN_LEVELS; ++level, length = 2.0f * length)
		bits = blend_int(bits, bits | first << level, length < splat(0.5f * GRAIN_SIZE));
	return bits;
}

// Returns the COLLIDABLE_GRAIN and COLLIDABLE_REACH bits of a dynamic collidable. thickness: m, from the centroid to
// the nearest side. A segment has no thickness and gets no bits, because other collidables come to rest on it.
INLINE Int transform_grains(Real thickness, Real reach)
{
	Int thin = (thickness < splat(0.5f * GRAIN_SIZE)) & (thickness != splat(0.0f)), none = 0 * thin;
	if (!lane_bits(thin))
		return none;
	Int bits = transform_bits(thickness, COLLIDABLE_GRAIN) | transform_bits(REACH_SHARE * reach, COLLIDABLE_REACH);
	return blend_int(none, bits, thin);
}

#endif
