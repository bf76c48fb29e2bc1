// SPDX-License-Identifier: MIT
// packed.h -- tests one box, at rest or moving, against eight packed boxes, one after another; a part of dialect.h.
#ifndef PACKED_H
#define PACKED_H

// Eight boxes are packed bound by bound: all lower x, all lower y, all upper x, all upper y. Thus a vector of eight
// floats contains one bound of all boxes without a transposition, and a GPU reads four bounds at a time.

// Returns a bit mask of the packed boxes that overlap a box: bit k for packed box k.
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

// Returns a bit mask of the packed boxes that a moving box meets (bit k: packed box k) at a fraction of its path up to
// `most`. sides: x and y of the sides that enter other boxes first, then of the sides that leave last. inverse: 1 / x
// and 1 / y of the path. enter: fractions at which the packed boxes are entered, at least 0. All operations are
// monotonic: a box that encloses other boxes is entered no later than these.
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

// Returns a bit mask of the packed boxes near a box, at a squared distance of at most `most` (bit k: packed box k).
// Sets square[k] to the squared distance of packed box k.
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
