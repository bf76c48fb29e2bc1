// SPDX-License-Identifier: MIT
// wide.h -- defines the dialect in C for 4, 8 and 16 lanes, with vectors of gcc and clang; included by dialect.h.
#ifndef WIDE_H
#define WIDE_H
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#define read_row8(base, index, out) memcpy(out, (base) + 8 * (size_t)(index), 32)
typedef float Real __attribute__((vector_size(4 * LANES)));
typedef int Int __attribute__((vector_size(4 * LANES)));
typedef Word Words __attribute__((vector_size(4 * LANES)));
// a difference keeps the sign of a zero: -0 - 0 is -0, but -0 + 0 is +0
#define splat(x)               ((x) - (Real){0})
#define load(array, i)         (*(const Real*)((array) + (i)))
#define load_int(array, i)     (*(const Int*)((array) + (i)))
#define store(array, i, x)     (*(Real*)((array) + (i)) = (x))
#define store_int(array, i, x) (*(Int*)((array) + (i)) = (x))
INLINE void store_lanes(float* to, Real x, int first, int count)
{
	memcpy(to, (const char*)&x + sizeof(float) * (size_t)first, sizeof(float) * (size_t)count);
}
#define real_bits(x) ((Int)(x))
#define bits_real(x) ((Real)(x))
#define lane(x, k)   ((x)[k])
#if LANES == 8 && defined(__AVX__)
INLINE Real blend(Real a, Real b, Int c) { return (Real)_mm256_blendv_ps((__m256)a, (__m256)b, (__m256)c); }
INLINE Int blend_int(Int a, Int b, Int c) { return (Int)blend((Real)a, (Real)b, c); }
#else
INLINE Real blend(Real a, Real b, Int c) { return (Real)(((Int)b & c) | ((Int)a & ~c)); }
INLINE Int blend_int(Int a, Int b, Int c) { return (b & c) | (a & ~c); }
#endif

INLINE Real only(Real x, Int c) { return (Real)((Int)x & c); }
#ifdef __wasm_simd128__
INLINE Real absolute(Real x) { return (Real)wasm_f32x4_abs((v128_t)x); } // clang 14 would store a constant of 16 bytes
#else
INLINE Real absolute(Real x) { return (Real)((Int)x & 0x7fffffff); }
#endif
#include "dialect/extremes.h"

#define whole(x)         __builtin_convertvector(x, Int)
#define real_of(x)       __builtin_convertvector(x, Real)
#define shifted(x, bits) ((Int)((Words)(x) << (bits)))
INLINE void store_keys(Word64* array, int i, Int high, Int low)
{
	for (int k = 0; k < LANES; ++k)
		array[i + k] = (Word64)(Word)high[k] << 32 | (Word64)(Word)low[k];
}
#include "dialect/transpose.h"

#endif
