// SPDX-License-Identifier: MIT
// dialect.h -- what C and OpenCL C do not share. The only file of the stages that asks which compiler is reading it.
//
// A wide stage computes in Real and Int. On the GPU they are float and int. On the CPU they are LANES floats and LANES
// ints, so that one call does one block. A stage that branches on an item is compiled with LANES 1; branching on a
// vector does not compile, so the mistake cannot pass.
//
// docs/dialect.md has the table of words.
#ifndef DIALECT_H
#define DIALECT_H

// The wide passes are inlined whole: clang left calls in them that cost 18 to 36 % at 8 and 16 lanes. With one lane the
// same made gcc half as fast again, for want of registers.
#if defined(LANES) && LANES > 1
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

// What few items need and would cost the others registers. On a GPU a call costs them as well.
#ifdef __OPENCL_C_VERSION__
#define RARE INLINE
#else
#define RARE static __attribute__((noinline))
#endif

#ifdef __OPENCL_C_VERSION__

#pragma OPENCL FP_CONTRACT OFF
#undef LANES
#define LANES  1
#define GLOBAL __global
typedef uint Word;
typedef ulong Word64;
typedef float2 Float2;
typedef float4 Float4;
typedef int2 Int2;
#define make_float2(a, b)       ((Float2)((a), (b)))
#define make_float4(a, b, c, d) ((Float4)((a), (b), (c), (d)))
#define make_int2(a, b)         ((Int2)((a), (b)))
#define float_bits(x)           as_int(x)
#define float_word(x)           as_uint(x)
#define bits_float(x)           as_float(x)
#define leading_zeros(x)        ((int)clz(x))
#define square_root(x)          sqrt(x)

// integer atomics: they count and build sets; whatever they collect is sorted before anything reads it in order
#define atomic_add_int(place, x)  atomic_add(place, x)
#define atomic_max_int(place, x)  atomic_max(place, x)
#define atomic_min_int(place, x)  atomic_min(place, x)
#define atomic_max_word(place, x) atomic_max(place, x)
#define atomic_and_word64(place, x)                                 \
	((void)atomic_and((volatile __global uint*)(place), (uint)(x)), \
	 (void)atomic_and((volatile __global uint*)(place) + 1, (uint)((x) >> 32)))
// Orders this work-item's memory accesses for the whole device, not its group alone, and drops what its first-level
// cache holds. OpenCL C 1.2 has no such fence; where none is known mem_fence has to do, which persistent.cl probes.
#ifdef __NV_CL_C_VERSION
#define DEVICE_FENCE() asm volatile("membar.gl;" ::: "memory")
#else
#define DEVICE_FENCE() mem_fence(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE)
#endif
// Counts an item in, and says how many came before it: the last one finds what all others left by atomics.
INLINE int arrive_int(GLOBAL int* place)
{
	DEVICE_FENCE();
	int before = atomic_add(place, 1);
	DEVICE_FENCE();
	return before;
}
// reads past first-level caches, which other compute units do not keep up to date
#define read_shared(place)            (*(volatile __global int*)(place))
#define read_shared_word(place)       (*(volatile __global uint*)(place))
#define read_shared_word64(place)     (*(volatile __global ulong*)(place))
#define write_shared_word(place, x)   (*(volatile __global uint*)(place) = (x))
#define write_shared_word64(place, x) (*(volatile __global ulong*)(place) = (x))
// other work-items have enough to do while one waits for memory
#define FETCHES           0
#define fetch_soon(place) ((void)0)

#else

#include <stdint.h>
#include <string.h>
#define GLOBAL
typedef uint32_t Word;
typedef uint64_t Word64;
typedef struct
{
	_Alignas(8) float x;
	float y;
} Float2;
typedef struct
{
	_Alignas(16) float x;
	float y, z, w;
} Float4;
typedef struct
{
	_Alignas(8) int x;
	int y;
} Int2;
#define make_float2(a, b)       ((Float2){(a), (b)})
#define make_float4(a, b, c, d) ((Float4){(a), (b), (c), (d)})
#define make_int2(a, b)         ((Int2){(a), (b)})
INLINE int float_bits(float x)
{
	int i;
	memcpy(&i, &x, 4);
	return i;
}
INLINE Word float_word(float x)
{
	Word i;
	memcpy(&i, &x, 4);
	return i;
}
INLINE float bits_float(int i)
{
	float x;
	memcpy(&x, &i, 4);
	return x;
}
INLINE int leading_zeros(Word64 x) { return __builtin_clzll(x); }
#define square_root(x)          __builtin_sqrtf(x)

#define FETCHES           1
#define fetch_soon(place) __builtin_prefetch(place)

#define gather_fixed_rows8(base, index, out) gather_rows8(base, index, out)

INLINE int atomic_add_int(int* place, int x) { return __atomic_fetch_add(place, x, __ATOMIC_RELAXED); }
INLINE int arrive_int(int* place) { return __atomic_fetch_add(place, 1, __ATOMIC_ACQ_REL); }
INLINE void atomic_and_word64(Word64* place, Word64 x) { __atomic_fetch_and(place, x, __ATOMIC_RELAXED); }
INLINE int read_shared(int* place) { return __atomic_load_n(place, __ATOMIC_RELAXED); }
INLINE Word read_shared_word(Word* place) { return __atomic_load_n(place, __ATOMIC_RELAXED); }
INLINE Word64 read_shared_word64(Word64* place) { return __atomic_load_n(place, __ATOMIC_RELAXED); }
INLINE void write_shared_word(Word* place, Word x) { __atomic_store_n(place, x, __ATOMIC_RELAXED); }
INLINE void write_shared_word64(Word64* place, Word64 x) { __atomic_store_n(place, x, __ATOMIC_RELAXED); }
INLINE void atomic_max_int(int* place, int x)
{
	int old = read_shared(place);
	while (old < x && !__atomic_compare_exchange_n(place, &old, x, 1, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
	{
	}
}
INLINE void atomic_min_int(int* place, int x)
{
	int old = read_shared(place);
	while (old > x && !__atomic_compare_exchange_n(place, &old, x, 1, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
	{
	}
}
INLINE void atomic_max_word(Word* place, Word x)
{
	Word old = read_shared_word(place);
	while (old < x && !__atomic_compare_exchange_n(place, &old, x, 1, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
	{
	}
}
#ifndef LANES
#define LANES 1
#endif
#if defined(__AVX2__) && LANES == 1
#include "dialect/overlaps.h"
#endif

#endif

// Raises a value that many may raise; most find it raised already.
INLINE void raise_int(GLOBAL int* place, int x)
{
	if (read_shared(place) < x)
		atomic_max_int(place, x);
}

// Which of eight boxes (lower x, y, upper x, y) overlap another one: bit k for box k.
#ifndef OVERLAPS8
INLINE Word overlaps8(const GLOBAL Float4* boxes, Float4 box)
{
	Word hits = 0;
	for (int k = 0; k < 8; ++k)
	{
		Float4 other = boxes[k];
		int hit = other.x <= box.z && box.x <= other.z && other.y <= box.w && box.y <= other.w;
		hits |= hit ? 1u << k : 0u;
	}
	return hits;
}
#endif

#if LANES == 1
typedef float Real;
typedef int Int;
#define splat(x)           (x)
#define load(array, i)     ((array)[i])
#define load_int(array, i) ((array)[i])
#define store(array, i, x) ((array)[i] = (x))
#define real_bits(x)       float_bits(x)
// b where c is set, else a
INLINE Real choose(Real a, Real b, Int c) { return c ? b : a; }
INLINE Int choose_int(Int a, Int b, Int c) { return c ? b : a; }
// of what is not negative and less than 2^31
#define whole(x) ((Int)(x))
// to the left, into the bit of the sign
#define shifted(x, bits) ((Int)((Word)(x) << (bits)))
// 64 bits each, of which the higher ones are to be sorted by
#define store_keys(array, i, high, low) ((array)[i] = (Word64)(Word)(high) << 32 | (Word64)(Word)(low))
#define root(x)                         square_root(x)

// items i to i + LANES - 1 themselves; what they name in an array; and the members of rows of two integers
#define indices(i)                  (i)
#define gather(array, index)        ((array)[index])
#define gather_int(array, index)    ((array)[index])
#define load_int2(array, i, x0, y0) (*(x0) = (array)[i].x, *(y0) = (array)[i].y)
// one bit a lane, set where c is; and the value of a lane
#define lane_bits(c) ((Word)((c) != 0))
#define lane(x, k)   (x)

// Rows of 8 and 4 floats. On a GPU they are read past the first-level cache, which in a kernel that goes through several
// passes may hold what another compute unit has changed since.
#ifdef __OPENCL_C_VERSION__
#define ROW volatile __global float4*
INLINE void row_parts(float4 low, float4 high, float out[8])
{
	out[0] = low.x;
	out[1] = low.y;
	out[2] = low.z;
	out[3] = low.w;
	out[4] = high.x;
	out[5] = high.y;
	out[6] = high.z;
	out[7] = high.w;
}
INLINE void gather_rows8(__global float* base, int index, float out[8])
{
	row_parts(((ROW)base)[2 * index], ((ROW)base)[2 * index + 1], out);
}
// rows that no work-item changes while the kernel reads them: from any cache
INLINE void gather_fixed_rows8(const __global float* base, int index, float out[8])
{
	const __global float4* row = (const __global float4*)base + 2 * index;
	row_parts(row[0], row[1], out);
}
INLINE void store_rows8(__global float* base, int first, const float in[8])
{
	((ROW)base)[2 * first] = (float4)(in[0], in[1], in[2], in[3]);
	((ROW)base)[2 * first + 1] = (float4)(in[4], in[5], in[6], in[7]);
}
INLINE void load_rows4(__global float* base, int first, float out[4])
{
	float4 row = ((ROW)base)[first];
	out[0] = row.x;
	out[1] = row.y;
	out[2] = row.z;
	out[3] = row.w;
}
INLINE void store_rows4(__global float* base, int first, const float in[4])
{
	((ROW)base)[first] = (float4)(in[0], in[1], in[2], in[3]);
}
INLINE void scatter_rows4of8(__global float* base, int index, const float in[4], int wanted)
{
	if (wanted)
		((ROW)base)[2 * index] = (float4)(in[0], in[1], in[2], in[3]);
}
#else
INLINE void gather_rows8(const float* base, int index, float out[8]) { memcpy(out, base + 8 * (size_t)index, 32); }
INLINE void store_rows8(float* base, int first, const float in[8]) { memcpy(base + 8 * (size_t)first, in, 32); }
INLINE void load_rows4(const float* base, int first, float out[4]) { memcpy(out, base + 4 * (size_t)first, 16); }
INLINE void store_rows4(float* base, int first, const float in[4]) { memcpy(base + 4 * (size_t)first, in, 16); }
INLINE void scatter_rows4of8(float* base, int index, const float in[4], int wanted)
{
	if (wanted)
		memcpy(base + 8 * (size_t)index, in, 16);
}
#endif
#define load_rows8(base, first, out) gather_rows8(base, first, out)
// one row, whatever the number of lanes
#define read_row8(base, index, out) gather_rows8(base, index, out)
#else
#define read_row8(base, index, out) memcpy(out, (base) + 8 * (size_t)(index), 32)
typedef float Real __attribute__((vector_size(4 * LANES)));
typedef int Int __attribute__((vector_size(4 * LANES)));
typedef Word Words __attribute__((vector_size(4 * LANES)));
// a difference, for -0 + 0 is +0
#define splat(x)                    ((x) - (Real){0})
#define load(array, i)              (*(const Real*)((array) + (i)))
#define load_int(array, i)          (*(const Int*)((array) + (i)))
#define store(array, i, x)          (*(Real*)((array) + (i)) = (x))
#define real_bits(x)                ((Int)(x))
#define lane(x, k)                  ((x)[k])
// b where c is set, else a
INLINE Real choose(Real a, Real b, Int c) { return (Real)(((Int)b & c) | ((Int)a & ~c)); }
INLINE Int choose_int(Int a, Int b, Int c) { return (b & c) | (a & ~c); }
#define whole(x)                    __builtin_convertvector(x, Int)
#define shifted(x, bits)            ((Int)((Words)(x) << (bits)))
INLINE void store_keys(Word64* array, int i, Int high, Int low)
{
	for (int k = 0; k < LANES; ++k)
		array[i + k] = (Word64)(Word)high[k] << 32 | (Word64)(Word)low[k];
}
INLINE Real root(Real x)
{
	for (int k = 0; k < LANES; ++k)
		x[k] = __builtin_sqrtf(x[k]);
	return x;
}
#include "dialect/transpose.h"
#endif

// one meaning for NaN and -0 on every target: b is taken only when the comparison holds
INLINE Real maximum(Real a, Real b) { return choose(a, b, a < b); }
INLINE Real minimum(Real a, Real b) { return choose(a, b, b < a); }

// STAGE(name) { ... } says what happens to item i of the pools p; WIDE_STAGE(name) to items i to i + LANES - 1.
//
// LIST_STAGE(name, list, length) { ... } is a stage of which an item is put into a list of the pools, in any order, where it
// returns 1. A worker of a CPU counts many at once: with 16 of them, counting each in one place took half of a step.
//
// GROUP_STAGE(name) { ... } says what a group of work-items does together to item i, with GROUP_FLOATS floats of bench that
// they share. What the item consists of is split among them: group_lane() is where one of them begins and group_width() how
// far it goes on. On a CPU a worker is the whole group, and takes LANES at a time.
#define GROUP_FLOATS 3072
#ifdef __OPENCL_C_VERSION__
#define BENCH         __local
#define group_lane()  ((int)get_local_id(0))
#define group_width() ((int)get_local_size(0))
// all of the group wait for each other, and see what each has written to bench and pools
#define group_meet() barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE)
// the same of bench alone
#define bench_meet() barrier(CLK_LOCAL_MEM_FENCE)
#else
#define BENCH
#define group_lane()  0
#define group_width() LANES
#define group_meet()
#define bench_meet()
#endif
#ifdef __OPENCL_C_VERSION__
// parentheses around a kernel's name, because a macro (store) may have the same
#define STAGE(name)                                                                                   \
	INLINE void name##_item(const Pools* p, int i);                                                   \
	__kernel void(name)(POOL_ARGUMENTS Step step, Run run)                                            \
	{                                                                                                 \
		Pools pools = {POOL_NAMES step, run.argument};                                                \
		int end = run.count < 0 ? run.end : min(run.end, ((__global int*)pools.counters)[run.count]); \
		for (int i = run.begin + (int)get_global_id(0); i < end; i += (int)get_global_size(0))        \
			name##_item(&pools, i);                                                                   \
	}                                                                                                 \
	INLINE void name##_item(const Pools* p, int i)
#define WIDE_STAGE(name) STAGE(name)
#define LIST_STAGE(name, list, length)                            \
	INLINE int name##_listed(const Pools* p, int i);              \
	STAGE(name)                                                   \
	{                                                             \
		if (name##_listed(p, i))                                  \
			p->list[atomic_add_int(&p->counters->length, 1)] = i; \
	}                                                             \
	INLINE int name##_listed(const Pools* p, int i)
#define GROUP_STAGE(name)                                                                             \
	INLINE void name##_group(const Pools* p, int i, BENCH float* bench);                              \
	__kernel void(name)(POOL_ARGUMENTS Step step, Run run)                                            \
	{                                                                                                 \
		__local float bench[GROUP_FLOATS];                                                            \
		Pools pools = {POOL_NAMES step, run.argument};                                                \
		int end = run.count < 0 ? run.end : min(run.end, ((__global int*)pools.counters)[run.count]); \
		for (int i = run.begin + (int)get_group_id(0); i < end; i += (int)get_num_groups(0))          \
			name##_group(&pools, i, bench);                                                           \
	}                                                                                                 \
	INLINE void name##_group(const Pools* p, int i, BENCH float* bench)
#else
#define STAGE_JOIN_(name, lanes) name##_lanes##lanes
#define STAGE_JOIN(name, lanes)  STAGE_JOIN_(name, lanes)
#define STAGE(name)                                                         \
	INLINE void name##_item(const Pools* p, int i);                         \
	static void STAGE_JOIN(name, LANES)(const Pools* p, int begin, int end) \
	{                                                                       \
		for (int i = begin; i < end; i += LANES)                            \
			name##_item(p, i);                                              \
	}                                                                       \
	INLINE void name##_item(const Pools* p, int i)
#define WIDE_STAGE(name) STAGE(name)
#define LIST_STAGE(name, list, length)                                                                               \
	INLINE int name##_listed(const Pools* p, int i);                                                                 \
	static void STAGE_JOIN(name, LANES)(const Pools* p, int begin, int end)                                          \
	{                                                                                                                \
		int found[HANDED_ITEMS], count = 0;                                                                          \
		for (int i = begin; i < end; ++i)                                                                            \
		{                                                                                                            \
			found[count] = i;                                                                                        \
			count += name##_listed(p, i);                                                                            \
			if (count < HANDED_ITEMS && i + 1 < end)                                                                 \
				continue;                                                                                            \
			if (count > 0)                                                                                           \
				memcpy(p->list + atomic_add_int(&p->counters->length, count), found, (size_t)count * sizeof *found); \
			count = 0;                                                                                               \
		}                                                                                                            \
	}                                                                                                                \
	INLINE int name##_listed(const Pools* p, int i)
#define GROUP_STAGE(name)                                                   \
	INLINE void name##_group(const Pools* p, int i, float* bench);          \
	static void STAGE_JOIN(name, LANES)(const Pools* p, int begin, int end) \
	{                                                                       \
		_Alignas(64) float bench[GROUP_FLOATS];                             \
		for (int i = begin; i < end; ++i)                                   \
			name##_group(p, i, bench);                                      \
	}                                                                       \
	INLINE void name##_group(const Pools* p, int i, float* bench)
#endif
#endif
