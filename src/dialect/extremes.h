// SPDX-License-Identifier: MIT
// extremes.h -- computes minimum and maximum of vectors by one instruction, with the dialect's results; part of wide.h.
// The instruction of x86 returns its first operand if this is larger than the second (for minimum: smaller). Otherwise,
// also for NaN and for two zeros, it returns its second operand.
#ifndef EXTREMES_H
#define EXTREMES_H

#if LANES == 16 && defined(__AVX512F__)
#define WIDE_EXTREMES
INLINE Real maximum(Real a, Real b) { return (Real)_mm512_max_ps((__m512)b, (__m512)a); }
INLINE Real minimum(Real a, Real b) { return (Real)_mm512_min_ps((__m512)b, (__m512)a); }
#elif LANES == 8 && defined(__AVX__)
#define WIDE_EXTREMES
INLINE Real maximum(Real a, Real b) { return (Real)_mm256_max_ps((__m256)b, (__m256)a); }
INLINE Real minimum(Real a, Real b) { return (Real)_mm256_min_ps((__m256)b, (__m256)a); }
#elif LANES == 4 && defined(__SSE2__)
#define WIDE_EXTREMES
INLINE Real maximum(Real a, Real b) { return (Real)_mm_max_ps((__m128)b, (__m128)a); }
INLINE Real minimum(Real a, Real b) { return (Real)_mm_min_ps((__m128)b, (__m128)a); }
#elif LANES == 4 && defined(__wasm_simd128__)
#define WIDE_EXTREMES
INLINE Real maximum(Real a, Real b) { return (Real)wasm_f32x4_pmax((v128_t)a, (v128_t)b); }
INLINE Real minimum(Real a, Real b) { return (Real)wasm_f32x4_pmin((v128_t)a, (v128_t)b); }
#endif

#endif
