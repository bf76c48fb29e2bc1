// SPDX-License-Identifier: MIT
// overlaps.h -- one box against eight, at rest or moving, with AVX2 or in WebAssembly; a part of dialect.h, whose words it uses.
#ifndef OVERLAPS_H
#define OVERLAPS_H
#ifdef __wasm_simd128__
#include <wasm_simd128.h>

// A box against one other at a time, in four lanes: with the upper bounds negated on both sides, all four comparisons are the same.
// WebAssembly has no eight lanes, and transposing the boxes would take longer. The other tests need no more than scalar code.
static inline Word overlaps8(const Float4* boxes, Float4 box)
{
	v128_t sign = wasm_f32x4_const(0.0f, 0.0f, -0.0f, -0.0f), most = wasm_f32x4_make(box.z, box.w, -box.x, -box.y);
	Word hits = 0;
	for (int k = 0; k < 8; ++k)
	{
		v128_t other = wasm_v128_xor(wasm_v128_load(boxes + k), sign);
		hits |= (Word)(wasm_i32x4_bitmask(wasm_f32x4_le(other, most)) == 15) << k;
	}
	return hits;
}
#define OVERLAPS8
#else
#include <immintrin.h>

static inline __m256 box_pair(const Float4* low, const Float4* high)
{
	return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(&low->x)), _mm_load_ps(&high->x), 1);
}

typedef struct // the bounds of eight boxes, each in one register, in order
{
	__m256 lower_x, lower_y, upper_x, upper_y;
} Boxes8;

// Boxes 0 to 3 are loaded into the low halves and 4 to 7 into the high halves, so a transposition within the halves
// leaves each of the four bounds of all eight boxes in one register, in order.
static inline Boxes8 boxes8(const Float4* boxes)
{
	__m256 r0 = box_pair(boxes, boxes + 4), r1 = box_pair(boxes + 1, boxes + 5);
	__m256 r2 = box_pair(boxes + 2, boxes + 6), r3 = box_pair(boxes + 3, boxes + 7);
	__m256 low01 = _mm256_unpacklo_ps(r0, r1), low23 = _mm256_unpacklo_ps(r2, r3);
	__m256 high01 = _mm256_unpackhi_ps(r0, r1), high23 = _mm256_unpackhi_ps(r2, r3);
	return (Boxes8){_mm256_shuffle_ps(low01, low23, 0x44), _mm256_shuffle_ps(low01, low23, 0xee),
	                _mm256_shuffle_ps(high01, high23, 0x44), _mm256_shuffle_ps(high01, high23, 0xee)};
}

// Called, rather than inlined, in the walks of the broad phase, it cost storm 2 % more instructions.
static inline __attribute__((always_inline)) Word overlaps8(const Float4* boxes, Float4 box)
{
	Boxes8 b = boxes8(boxes);
	__m256 x = _mm256_and_ps(_mm256_cmp_ps(b.lower_x, _mm256_set1_ps(box.z), _CMP_LE_OQ),
	                         _mm256_cmp_ps(_mm256_set1_ps(box.x), b.upper_x, _CMP_LE_OQ));
	__m256 y = _mm256_and_ps(_mm256_cmp_ps(b.lower_y, _mm256_set1_ps(box.w), _CMP_LE_OQ),
	                         _mm256_cmp_ps(_mm256_set1_ps(box.y), b.upper_y, _CMP_LE_OQ));
	return (Word)_mm256_movemask_ps(_mm256_and_ps(x, y));
}
#define OVERLAPS8

static inline __m256 along8(__m256 bound, float side, float inverse)
{
	return _mm256_mul_ps(_mm256_sub_ps(bound, _mm256_set1_ps(side)), _mm256_set1_ps(inverse));
}

static inline Word beam8(const Float4* boxes, Float4 sides, Float2 inverse, float most, float enter[8])
{
	Boxes8 b = boxes8(boxes);
	int right = inverse.x > 0.0f, up = inverse.y > 0.0f;
	__m256 enter_x = along8(right ? b.lower_x : b.upper_x, sides.x, inverse.x);
	__m256 enter_y = along8(up ? b.lower_y : b.upper_y, sides.y, inverse.y);
	__m256 leave_x = along8(right ? b.upper_x : b.lower_x, sides.z, inverse.x);
	__m256 leave_y = along8(up ? b.upper_y : b.lower_y, sides.w, inverse.y);
	__m256 first = _mm256_max_ps(_mm256_max_ps(enter_x, enter_y), _mm256_setzero_ps());
	__m256 last = _mm256_min_ps(_mm256_min_ps(leave_x, leave_y), _mm256_set1_ps(most));
	_mm256_storeu_ps(enter, first);
	return (Word)_mm256_movemask_ps(_mm256_cmp_ps(first, last, _CMP_LE_OQ));
}

static inline Word apart8(const Float4* boxes, Float4 box, float most, float square[8])
{
	Boxes8 b = boxes8(boxes);
	__m256 right = _mm256_sub_ps(b.lower_x, _mm256_set1_ps(box.z)),
	       up = _mm256_sub_ps(b.lower_y, _mm256_set1_ps(box.w));
	__m256 left = _mm256_sub_ps(_mm256_set1_ps(box.x), b.upper_x),
	       down = _mm256_sub_ps(_mm256_set1_ps(box.y), b.upper_y);
	__m256 x = _mm256_max_ps(_mm256_max_ps(right, left), _mm256_setzero_ps());
	__m256 y = _mm256_max_ps(_mm256_max_ps(up, down), _mm256_setzero_ps());
	__m256 squares = _mm256_add_ps(_mm256_mul_ps(x, x), _mm256_mul_ps(y, y));
	_mm256_storeu_ps(square, squares);
	return (Word)_mm256_movemask_ps(_mm256_cmp_ps(squares, _mm256_set1_ps(most), _CMP_LE_OQ));
}
#define BEAM8

#endif
#endif
