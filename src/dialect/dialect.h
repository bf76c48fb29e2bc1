// SPDX-License-Identifier: MIT
// dialect.h -- hides the differences between C and OpenCL C; no other file of the kernels tests the compiler.
//
// Wide kernels compute with Real and Int: float and int on a GPU, vectors of LANES numbers on a CPU. Kernels that
// branch on an item are compiled with LANES 1, because a branch on a vector does not compile. Names: docs/design/dialect.md.
#ifndef DIALECT_H
#define DIALECT_H

// INLINE functions of wide passes are always inlined: calls that clang left in these passes took 18 to 36 % more time
// at 8 and 16 lanes. With one lane, always inlining slowed code of gcc by half, because registers ran out. On a GPU, a
// single call keeps the pools on the stack of every work-item, and costs 0.08 ms per step of 93,000 bodies of ragdolls
// (H200). CALLS is defined for OpenCL on a CPU, because PoCL takes over 40 % longer to build always inlined functions.
#if (defined(LANES) && LANES > 1) || (defined(__OPENCL_C_VERSION__) && !defined(CALLS))
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

// Marks functions with a barrier, and those that call them. On a device they are always inlined: PoCL would do so
// itself, and llvmpipe (Mesa 25.0) crashes when it compiles a call of a function with a barrier.
#ifdef __OPENCL_C_VERSION__
#define INLINE_MEET static inline __attribute__((always_inline))
#else
#define INLINE_MEET INLINE
#endif

// Inlines long parts of hot kernels with one lane; gcc would call them, and return their results through memory.
#ifdef CALLS
#define INLINE_LONG INLINE
#else
#define INLINE_LONG static inline __attribute__((always_inline))
#endif

// Marks large parts, without barriers, of large kernels. With CALLS they are not inlined, because PoCL copies inlined
// code three times, and nine times between barriers that not all work-items reach. In WebAssembly they are not
// inlined, so that pages are smaller.
#if defined(CALLS) || defined(__EMSCRIPTEN__)
#define OUT_OF_LINE static __attribute__((noinline))
#else
#define OUT_OF_LINE INLINE
#endif

// 1 in builds that must be small, as for WebAssembly: code is left out whose work other code can do.
#ifdef SCREE_SMALL
#define SMALL_CODE 1
#else
#define SMALL_CODE 0
#endif

// Marks code that few items need. Inlined on a CPU, it would take registers from all items; on a GPU, so would a call.
#ifdef __OPENCL_C_VERSION__
#define RARE INLINE
#else
#define RARE static __attribute__((noinline))
#endif

// Unrolls a loop of two or three iterations over arrays, so that the arrays stay in registers: joint_bias needed 89
// registers on an H200 with it, and 185 without. WebAssembly does not unroll, because a page downloads the code.
#if defined(__OPENCL_C_VERSION__) || (defined(__clang__) && !defined(__EMSCRIPTEN__))
#define UNROLL _Pragma("unroll")
#elif defined(__GNUC__) && !defined(__clang__)
#define UNROLL _Pragma("GCC unroll 4")
#else
#define UNROLL
#endif

// Enclose kernels that few worlds run: WebAssembly compiles them for size, which saves 1.5 kB of compressed code.
#ifdef __EMSCRIPTEN__
#define SMALL_BEGIN _Pragma("clang attribute push(__attribute__((minsize)), apply_to = function)")
#define SMALL_END   _Pragma("clang attribute pop")
#else
#define SMALL_BEGIN
#define SMALL_END
#endif

// Macros that define kernels, in opencl_words.h and c_words.h.
// KERNEL(name) { ... }: the code for item i of the pools p. WIDE_KERNEL(name): the code for items i to i + LANES - 1.
// LIST_KERNEL(name, list, length) { ... }: the code returns an item, which is appended to a list of the pools, in any
// order, or -1. A CPU worker advances the length once per CHUNK_ITEMS items: with 16 workers, an atomic addition per
// item took half of a step.
// GROUP_KERNEL(name) { ... }: the code that a work-group executes together for item i, with GROUP_FLOATS floats of
// local memory, bench. A work-item processes every group_width()-th part of the item from part group_lane() on. On a
// CPU one worker is the whole group, and processes LANES parts at a time; part_lane() and part_width() are for code in
// which it processes one part at a time.
#define GROUP_FLOATS 3072

#ifdef __OPENCL_C_VERSION__
#include "dialect/opencl_words.h"
#else
#include "dialect/c_words.h"
#if (defined(__AVX2__) || defined(__wasm_simd128__)) && LANES == 1
#include "dialect/box_overlaps.h"
#endif
#endif

// Marks a short function that has many callers. In WebAssembly they call it, which saves 0.1 kB of the package, compressed.
#ifdef __EMSCRIPTEN__
#define INLINE_SHORT static inline __attribute__((noinline))
#else
#define INLINE_SHORT INLINE
#endif

// Raises the number at `place` to at least x, atomically. A plain read first avoids most of the atomic operations.
INLINE_SHORT void raise_int(GLOBAL int* place, int x)
{
	if (read_shared(place) < x)
		atomic_max_int(place, x);
}

#include "dialect/packed.h"

#if LANES == 1
typedef float Real;
typedef int Int;
typedef Word Words;
#define splat(x)               (x)
#define load(array, i)         ((array)[i])
#define load_int(array, i)     ((array)[i])
#define store(array, i, x)     ((array)[i] = (x))
#define store_int(array, i, x) ((array)[i] = (x))
// Stores `count` lanes of x from lane `first` on, at `to`.
#define store_lanes(to, x, first, count) (*(to) = (x))
#define real_bits(x)                     float_bits(x)
#define bits_real(x)                     bits_float(x)
INLINE Real blend(Real a, Real b, Int c) { return c ? b : a; }
INLINE Int blend_int(Int a, Int b, Int c) { return c ? b : a; }
// Conversions between Real and Int, of values from 0 to below 2^31.
#define whole(x)   ((Int)(x))
#define real_of(x) ((Real)(x))
// Shifts an Int left; bits may enter the sign bit.
#define shifted(x, bits)                ((Int)((Word)(x) << (bits)))
#define store_keys(array, i, high, low) ((array)[i] = (Word64)(Word)(high) << 32 | (Word64)(Word)(low))
#define root(x)                         square_root(x)
#ifndef absolute
#define absolute(x) __builtin_fabsf(x)
#endif
INLINE Real only(Real x, Int c) { return c ? x : 0.0f; }

// following(a, b), preceding(a, b): see transpose.h, which has the versions for several lanes.
#define following(a, b)     (b)
#define preceding(a, b)     (a)
#define following_int(a, b) (b)
#define preceding_int(a, b) (a)

// indices(i): the numbers i to i + LANES - 1. gather: an item of an array for each lane, by index. load_int2,
// store_int2: the members of LANES pairs, from pair i on.
#define indices(i)               (i)
#define gather(array, index)     ((array)[index])
#define gather_int(array, index) ((array)[index])
// Pairs of floats by index: their first and second members.
#define gather_pairs(base, index, x, y) (*(x) = (base)[2 * (index)], *(y) = (base)[2 * (index) + 1])
#define load_int2(array, i, x0, y0)     (*(x0) = (array)[i].x, *(y0) = (array)[i].y)
#define store_int2(array, i, x0, y0)    ((array)[i] = make_int2(x0, y0))
// lane_bits: bit mask of the lanes in which c is not 0. lane: the value of one lane.
#define lane_bits(c)                   ((Word)((c) != 0))
#define lane(x, k)                     (x)
#define load_rows8(base, first, out)   gather_rows8(base, first, out)
#define gather_rows4(base, index, out) load_rows4(base, index, out)
// Reads the row of one item, for any number of lanes.
#define read_row8(base, index, out) gather_rows8(base, index, out)
#else
#include "dialect/wide.h"
#endif

// maximum and minimum, with defined results for NaN and -0 on every device: b if the comparison holds, otherwise a.
#ifndef WIDE_EXTREMES
INLINE Real maximum(Real a, Real b) { return blend(a, b, a < b); }
INLINE Real minimum(Real a, Real b) { return blend(a, b, b < a); }
#endif

#endif
