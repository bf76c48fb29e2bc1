// SPDX-License-Identifier: MIT
// exact_floats.h -- refuses compiler flags that change the bits of floats, and turns off fused multiply-adds.
//
// Every file of src/ and scene/ includes it, so it also works in a build without cmake/flags.cmake, which sets these
// flags. Two kinds of flags leave no trace in macros: those that fuse, and most of clang's. Pragmas undo them here, and
// cpu/self_test.c finds the rest.
#ifndef EXACT_FLOATS_H
#define EXACT_FLOATS_H

#if defined(__FAST_MATH__)
#error "scree: -ffast-math and -Ofast change the bits of floats, so worlds would differ; compile with -fno-fast-math"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "scree: -ffinite-math-only removes the checks for NaN; compile with -fno-finite-math-only"
#elif defined(__ASSOCIATIVE_MATH__)
#error "scree: -fassociative-math changes the order of float sums; compile with -fno-associative-math"
#elif defined(__RECIPROCAL_MATH__)
#error "scree: -freciprocal-math divides with two roundings; compile with -fno-reciprocal-math"
#elif defined(__NO_SIGNED_ZEROS__)
#error "scree: -fno-signed-zeros changes the signs of zeros; compile with -fsigned-zeros"
#elif defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "scree: floats are computed with excess precision; on x86 compile with -msse2 -mfpmath=sse"
#endif

#ifndef __cplusplus
_Static_assert(sizeof(1.0) == sizeof(double),
               "scree: -fsingle-precision-constant makes doubles floats; compile with -fno-single-precision-constant");
#endif

// WebAssembly has no instructions that fuse.
#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(precise, on) // clang defines no macros for -fassociative-math and the like
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && !defined(__clang__) && defined(__FP_FAST_FMAF)
#pragma GCC optimize("fp-contract=off")
#if defined(__x86_64__) || defined(__i386__)
// gcc 12 vectorizes a * b - c beside a * b + c to vfmaddsub without regard to -ffp-contract=off. Loops of 16 lanes have no
// such pairs, and without vectorized loops their code grows by 10 %; tests/test_flags.sh searches the code.
#pragma GCC optimize("no-tree-slp-vectorize")
#if !defined(LANES) || LANES < 16
#pragma GCC optimize("no-tree-loop-vectorize")
#endif
#endif
#endif

#endif
