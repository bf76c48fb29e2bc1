// SPDX-License-Identifier: MIT
// overlaps.h -- one box against eight, with AVX2; a part of dialect.h, whose words it uses.
#ifndef OVERLAPS_H
#define OVERLAPS_H
#include <immintrin.h>

static inline __m256 box_pair(const Float4* low, const Float4* high)
{
	return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(&low->x)), _mm_load_ps(&high->x), 1);
}

// Boxes 0 to 3 are loaded into the low halves and 4 to 7 into the high halves, so a transposition within the halves
// leaves each of the four bounds of all eight boxes in one register, in order.
static inline Word overlaps8(const Float4* boxes, Float4 box)
{
	__m256 r0 = box_pair(boxes, boxes + 4), r1 = box_pair(boxes + 1, boxes + 5);
	__m256 r2 = box_pair(boxes + 2, boxes + 6), r3 = box_pair(boxes + 3, boxes + 7);
	__m256 low01 = _mm256_unpacklo_ps(r0, r1), low23 = _mm256_unpacklo_ps(r2, r3);
	__m256 high01 = _mm256_unpackhi_ps(r0, r1), high23 = _mm256_unpackhi_ps(r2, r3);
	__m256 lower_x = _mm256_shuffle_ps(low01, low23, 0x44), lower_y = _mm256_shuffle_ps(low01, low23, 0xee);
	__m256 upper_x = _mm256_shuffle_ps(high01, high23, 0x44), upper_y = _mm256_shuffle_ps(high01, high23, 0xee);
	__m256 x = _mm256_and_ps(_mm256_cmp_ps(lower_x, _mm256_set1_ps(box.z), _CMP_LE_OQ),
	                         _mm256_cmp_ps(_mm256_set1_ps(box.x), upper_x, _CMP_LE_OQ));
	__m256 y = _mm256_and_ps(_mm256_cmp_ps(lower_y, _mm256_set1_ps(box.w), _CMP_LE_OQ),
	                         _mm256_cmp_ps(_mm256_set1_ps(box.y), upper_y, _CMP_LE_OQ));
	return (Word)_mm256_movemask_ps(_mm256_and_ps(x, y));
}
#define OVERLAPS8

#endif
