// SPDX-License-Identifier: MIT
// packed.h -- tests of one box, at rest or moving, against eight packed ones in turn; a part of dialect.h.
#ifndef PACKED_H
#define PACKED_H

// Eight boxes are packed bound by bound: all lower x, lower y, upper x, upper y (src/stages/geometry/box.h). So a
// vector of eight contains one bound of all boxes without a transposition, and a GPU reads four bounds at a time.

// Returns which of eight packed boxes overlap another one: bit k for box k.
#ifndef OVERLAPS8
INLINE Word overlaps8(const GLOBAL Float4* boxes, Float4 box)
{
	Word hits = 0;
	Bound8 lower_x = bound8(boxes, 0), lower_y = bound8(boxes, 1);
	Bound8 upper_x = bound8(boxes, 2), upper_y = bound8(boxes, 3);
	UNROLL
	for (int k = 0; k < 8; ++k)
	{
		int hit = bound_at(lower_x, k) <= box.z && box.x <= bound_at(upper_x, k) && bound_at(lower_y, k) <= box.w &&
		          box.y <= bound_at(upper_y, k);
		hits |= hit ? 1u << k : 0u;
	}
	return hits;
}
#endif

// Returns which of eight packed boxes a moving box meets: bit k for box k. sides: x and y of its sides that enter
// first, then of those that leave last; inverse: of its path. enter: the fraction of the path at which each is entered,
// at least 0; fractions above most do not count. All operations are monotonic: a box around others is entered no later.
#ifndef BEAM8
INLINE Word beam8(const GLOBAL Float4* boxes, Float4 sides, Float2 inverse, float most, float enter[8])
{
	Word hits = 0;
	int right = inverse.x > 0.0f, up = inverse.y > 0.0f;
	Bound8 near_x = bound8(boxes, right ? 0 : 2), near_y = bound8(boxes, up ? 1 : 3);
	Bound8 far_x = bound8(boxes, right ? 2 : 0), far_y = bound8(boxes, up ? 3 : 1);
	UNROLL
	for (int k = 0; k < 8; ++k)
	{
		float enter_x = (bound_at(near_x, k) - sides.x) * inverse.x,
		      enter_y = (bound_at(near_y, k) - sides.y) * inverse.y;
		float leave_x = (bound_at(far_x, k) - sides.z) * inverse.x,
		      leave_y = (bound_at(far_y, k) - sides.w) * inverse.y;
		float first = enter_x > enter_y ? enter_x : enter_y, last = leave_x < leave_y ? leave_x : leave_y;
		first = first > 0.0f ? first : 0.0f;
		last = last < most ? last : most;
		enter[k] = first;
		hits |= first <= last ? 1u << k : 0u;
	}
	return hits;
}

// Returns which of eight packed boxes are near a box. square: squares of the distances; those above most do not count.
INLINE Word apart8(const GLOBAL Float4* boxes, Float4 box, float most, float square[8])
{
	Word hits = 0;
	Bound8 lower_x = bound8(boxes, 0), lower_y = bound8(boxes, 1);
	Bound8 upper_x = bound8(boxes, 2), upper_y = bound8(boxes, 3);
	UNROLL
	for (int k = 0; k < 8; ++k)
	{
		float right = bound_at(lower_x, k) - box.z, left = box.x - bound_at(upper_x, k);
		float up = bound_at(lower_y, k) - box.w, down = box.y - bound_at(upper_y, k);
		float x = right > left ? right : left, y = up > down ? up : down;
		x = x > 0.0f ? x : 0.0f;
		y = y > 0.0f ? y : 0.0f;
		square[k] = x * x + y * y;
		hits |= square[k] <= most ? 1u << k : 0u;
	}
	return hits;
}
#endif

#endif
