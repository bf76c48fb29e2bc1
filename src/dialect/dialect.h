// SPDX-License-Identifier: MIT
// dialect.h -- hides the differences between C and OpenCL C; no other file of the kernels tests the compiler.
//
// A wide kernel computes in Real and Int: float and int on a GPU; LANES of them on a CPU, so that one call computes one
// block. A kernel that branches on an item is compiled with LANES 1, because a branch on a vector does not compile.
// docs/dialect.md has the table of all names.
#ifndef DIALECT_H
#define DIALECT_H

// Functions of wide passes are always inlined: calls that clang left in them cost 18 to 36 % at 8 and 16 lanes. With
// one lane, always inlining made the code of gcc half as fast again, for lack of registers. On a GPU, one call keeps
// the pools on the stack of every work-item: a step of 93,000 bodies of ragdolls took 0.08 ms longer on an H200. CALLS
// is for OpenCL on a CPU, where PoCL takes over 40 % longer to build functions that are always inlined.
#if (defined(LANES) && LANES > 1) || (defined(__OPENCL_C_VERSION__) && !defined(CALLS))
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

// Inlines long parts of hot kernels with one lane, which gcc would not; a call would write its result to memory.
#ifdef CALLS
#define INLINE_LONG INLINE
#else
#define INLINE_LONG static inline __attribute__((always_inline))
#endif

// Marks large parts of large kernels, without barriers. With CALLS they are calls: PoCL makes three copies of a kernel,
// and in each three of code between barriers that not all work-items reach. In WebAssembly calls make a page smaller.
#if defined(CALLS) || defined(__EMSCRIPTEN__)
#define OUT_OF_LINE static __attribute__((noinline))
#else
#define OUT_OF_LINE INLINE
#endif

// Marks code that few items need: inlined, it would use registers of all items. On a GPU a call uses them as well.
#ifdef __OPENCL_C_VERSION__
#define RARE INLINE
#else
#define RARE static __attribute__((noinline))
#endif

// Unrolls a loop of two or three iterations over arrays, so that the arrays stay in registers: with it, joint_bias
// needed 89 registers on an H200, without it 185. WebAssembly does not unroll, because a page downloads the code.
#if defined(__OPENCL_C_VERSION__) || (defined(__clang__) && !defined(__EMSCRIPTEN__))
#define UNROLL _Pragma("unroll")
#elif defined(__GNUC__) && !defined(__clang__)
#define UNROLL _Pragma("GCC unroll 4")
#else
#define UNROLL
#endif

// Kernels between these have small code in WebAssembly, 1.5 kB less compressed, because most worlds do not run them.
#ifdef __EMSCRIPTEN__
#define SMALL_BEGIN _Pragma("clang attribute push(__attribute__((minsize)), apply_to = function)")
#define SMALL_END   _Pragma("clang attribute pop")
#else
#define SMALL_BEGIN
#define SMALL_END
#endif

// Macros of kernels, which opencl_words.h and c_words.h define:
// KERNEL(name) { ... }: the code for item i of the pools p. WIDE_KERNEL(name): the code for items i to i + LANES - 1.
//
// LIST_KERNEL(name, list, length) { ... }: a kernel that appends the items for which it returns 1 to a list of the
// pools, in any order. A CPU worker counts CHUNK_ITEMS of them at once: with 16 workers, one atomic counter per item
// took half of a step.
//
// GROUP_KERNEL(name) { ... }: the code that a work-group executes together for item i, with GROUP_FLOATS floats of
// local memory, bench. The parts of the item are split among the work-items: group_lane() is the first index of one,
// group_width() its stride. On a CPU one worker is the whole group, and processes LANES parts at a time; part_lane()
// and part_width() are for code that it executes one part at a time.
#define GROUP_FLOATS 3072

#ifdef __OPENCL_C_VERSION__
#include "dialect/opencl_words.h"
#else
#include "dialect/c_words.h"
#if (defined(__AVX2__) || defined(__wasm_simd128__)) && LANES == 1
#include "dialect/box_overlaps.h"
#endif
#endif

// Computes an atomic maximum, preceded by a plain read, because most items find the maximum there already.
INLINE void raise_int(GLOBAL int* place, int x)
{
	if (read_shared(place) < x)
		atomic_max_int(place, x);
}

#include "dialect/packed.h"

#if LANES == 1
typedef float Real;
typedef int Int;
#define splat(x)               (x)
#define load(array, i)         ((array)[i])
#define load_int(array, i)     ((array)[i])
#define store(array, i, x)     ((array)[i] = (x))
#define store_int(array, i, x) ((array)[i] = (x))
#define real_bits(x)           float_bits(x)
INLINE Real blend(Real a, Real b, Int c) { return c ? b : a; }
INLINE Int blend_int(Int a, Int b, Int c) { return c ? b : a; }
// Conversions of values from 0 to below 2^31.
#define whole(x)   ((Int)(x))
#define real_of(x) ((Real)(x))
// Shifts left, also into the sign bit.
#define shifted(x, bits)                ((Int)((Word)(x) << (bits)))
#define store_keys(array, i, high, low) ((array)[i] = (Word64)(Word)(high) << 32 | (Word64)(Word)(low))
#define root(x)                         square_root(x)

// following: the items after those of a, where b follows. preceding: the items before those of b, where a precedes.
#define following(a, b)     (b)
#define preceding(a, b)     (a)
#define following_int(a, b) (b)
#define preceding_int(a, b) (a)

// indices: numbers i to i + LANES - 1. gather: items by index. load_int2: the members of rows of two integers.
#define indices(i)                  (i)
#define gather(array, index)        ((array)[index])
#define gather_int(array, index)    ((array)[index])
#define load_int2(array, i, x0, y0) (*(x0) = (array)[i].x, *(y0) = (array)[i].y)
// lane_bits: a bit mask of the lanes where c is set. lane: the value of a lane.
#define lane_bits(c)                   ((Word)((c) != 0))
#define lane(x, k)                     (x)
#define load_rows8(base, first, out)   gather_rows8(base, first, out)
#define gather_rows4(base, index, out) load_rows4(base, index, out)
// Reads one row, whatever the number of lanes.
#define read_row8(base, index, out) gather_rows8(base, index, out)
#else
#include "dialect/wide.h"
#endif

// Returns defined results for NaN and -0 on every target: b is taken only if the comparison holds.
#ifndef WIDE_EXTREMES
INLINE Real maximum(Real a, Real b) { return blend(a, b, a < b); }
INLINE Real minimum(Real a, Real b) { return blend(a, b, b < a); }
#endif

#endif
