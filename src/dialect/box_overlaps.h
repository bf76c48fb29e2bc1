// SPDX-License-Identifier: MIT
// box_overlaps.h -- tests a box against eight boxes with AVX2, also a moving box, or WebAssembly; part of dialect.h.
#ifndef BOX_OVERLAPS_H
#define BOX_OVERLAPS_H
#ifdef __wasm_simd128__
#include <wasm_simd128.h>

static inline Word overlaps4(const float* bounds, Float4 box)
{
	v128_t x = wasm_v128_and(wasm_f32x4_le(wasm_v128_load(bounds), wasm_f32x4_splat(box.z)),
	                         wasm_f32x4_le(wasm_f32x4_splat(box.x), wasm_v128_load(bounds + 16)));
	v128_t y = wasm_v128_and(wasm_f32x4_le(wasm_v128_load(bounds + 8), wasm_f32x4_splat(box.w)),
	                         wasm_f32x4_le(wasm_f32x4_splat(box.y), wasm_v128_load(bounds + 24)));
	return (Word)wasm_i32x4_bitmask(wasm_v128_and(x, y));
}

static inline Word overlaps8(const Float4* boxes, Float4 box)
{
	return overlaps4(&boxes->x, box) | overlaps4(&boxes[1].x, box) << 4;
}
#define OVERLAPS8
#else
#include <immintrin.h>

static inline __m256 bound8_wide(const Float4* boxes, int which) { return _mm256_load_ps(&boxes[2 * which].x); }

// Always inlined, because calls in the traversals of the broad phase cost scene storm 2 % more instructions.
static inline __attribute__((always_inline)) Word overlaps8(const Float4* boxes, Float4 box)
{
	__m256 x = _mm256_and_ps(_mm256_cmp_ps(bound8_wide(boxes, 0), _mm256_set1_ps(box.z), _CMP_LE_OQ),
	                         _mm256_cmp_ps(bound8_wide(boxes, 2), _mm256_set1_ps(box.x), _CMP_GE_OQ));
	__m256 y = _mm256_and_ps(_mm256_cmp_ps(bound8_wide(boxes, 1), _mm256_set1_ps(box.w), _CMP_LE_OQ),
	                         _mm256_cmp_ps(bound8_wide(boxes, 3), _mm256_set1_ps(box.y), _CMP_GE_OQ));
	return (Word)_mm256_movemask_ps(_mm256_and_ps(x, y));
}
#define OVERLAPS8

static inline __m256 along8(__m256 bound, float side, float inverse)
{
	return _mm256_mul_ps(_mm256_sub_ps(bound, _mm256_set1_ps(side)), _mm256_set1_ps(inverse));
}

static inline Word beam8(const Float4* boxes, Float4 sides, Float2 inverse, float most, float enter[8])
{
	int right = inverse.x > 0.0f, up = inverse.y > 0.0f;
	__m256 enter_x = along8(bound8_wide(boxes, right ? 0 : 2), sides.x, inverse.x);
	__m256 enter_y = along8(bound8_wide(boxes, up ? 1 : 3), sides.y, inverse.y);
	__m256 leave_x = along8(bound8_wide(boxes, right ? 2 : 0), sides.z, inverse.x);
	__m256 leave_y = along8(bound8_wide(boxes, up ? 3 : 1), sides.w, inverse.y);
	__m256 first = _mm256_max_ps(_mm256_max_ps(enter_x, enter_y), _mm256_setzero_ps());
	__m256 last = _mm256_min_ps(_mm256_min_ps(leave_x, leave_y), _mm256_set1_ps(most));
	_mm256_storeu_ps(enter, first);
	return (Word)_mm256_movemask_ps(_mm256_cmp_ps(first, last, _CMP_LE_OQ));
}

static inline Word apart8(const Float4* boxes, Float4 box, float most, float square[8])
{
	__m256 right = _mm256_sub_ps(bound8_wide(boxes, 0), _mm256_set1_ps(box.z)),
	       up = _mm256_sub_ps(bound8_wide(boxes, 1), _mm256_set1_ps(box.w));
	__m256 left = _mm256_sub_ps(_mm256_set1_ps(box.x), bound8_wide(boxes, 2)),
	       down = _mm256_sub_ps(_mm256_set1_ps(box.y), bound8_wide(boxes, 3));
	__m256 x = _mm256_max_ps(_mm256_max_ps(right, left), _mm256_setzero_ps());
	__m256 y = _mm256_max_ps(_mm256_max_ps(up, down), _mm256_setzero_ps());
	__m256 squares = _mm256_add_ps(_mm256_mul_ps(x, x), _mm256_mul_ps(y, y));
	_mm256_storeu_ps(square, squares);
	return (Word)_mm256_movemask_ps(_mm256_cmp_ps(squares, _mm256_set1_ps(most), _CMP_LE_OQ));
}
#define BEAM8

#endif
#endif
