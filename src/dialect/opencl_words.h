// SPDX-License-Identifier: MIT
// opencl_words.h -- defines the dialect in OpenCL C; included by dialect.h.
#ifndef OPENCL_WORDS_H
#define OPENCL_WORDS_H

// FUSED and WORSE_ROUNDING are for tests: they make a device compute as if its compiler ignored the pragma, and as if
// it did not round quotients and roots correctly, with errors of -2 to 2 ulp.
#ifdef FUSED
#pragma OPENCL FP_CONTRACT ON
#else
#pragma OPENCL FP_CONTRACT OFF
#endif
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
#define absolute(x)             fabs(x)
#define leading_zeros(x)        ((int)clz(x))
#define lowest_bit(x)           (63 - leading_zeros((x) & (~(x) + (ulong)1)))

#ifdef WORSE_ROUNDING
INLINE float worse(float x) { return as_float(as_uint(x) + (as_uint(x) * 2654435761u >> 16) % 5u - 2u); }
#else
#define worse(x) (x)
#endif
// Devices that do not round quotients and roots correctly compile OWN_ROUNDING.
#ifdef OWN_ROUNDING
#define inexact_quotient(a, b) worse((a) / (b))
#define inexact_root(x)        worse(sqrt(x))
#include "dialect/own_rounding.h"
#define quotient(a, b) own_quotient(a, b)
#define square_root(x) own_root(x)
#else
#define quotient(a, b) worse((a) / (b))
#define square_root(x) worse(sqrt(x))
#endif

// Integer atomics: sums, maxima, minima and bit masks, which do not depend on the order of the work-items. Lists that
// grow by a counter are sorted before they are read in order.
#define atomic_add_int(place, x)  atomic_add(place, x)
#define atomic_max_int(place, x)  atomic_max(place, x)
#define atomic_min_int(place, x)  atomic_min(place, x)
#define atomic_or_int(place, x)   atomic_or(place, x)
#define atomic_max_word(place, x) atomic_max(place, x)
#define atomic_and_word64(place, x)                                 \
	((void)atomic_and((volatile __global uint*)(place), (uint)(x)), \
	 (void)atomic_and((volatile __global uint*)(place) + 1, (uint)((x) >> 32)))
// Orders memory accesses for all work-groups, and invalidates the first-level cache, which no fence of OpenCL C 1.2
// does. Compilers other than that of NVIDIA use mem_fence; persistent.cl tests whether it suffices.
#ifdef __NV_CL_C_VERSION
#define DEVICE_FENCE() asm volatile("membar.gl;" ::: "memory")
#else
#define DEVICE_FENCE() mem_fence(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE)
#endif
// Increments a counter atomically; returns the old value. The last item to arrive can read all writes of the others.
INLINE int arrive_int(GLOBAL int* place)
{
	DEVICE_FENCE();
	int before = atomic_add(place, 1);
	DEVICE_FENCE();
	return before;
}
// Volatile accesses bypass first-level caches, which are not coherent between compute units.
#define read_shared(place)            (*(volatile __global int*)(place))
#define read_shared_word(place)       (*(volatile __global uint*)(place))
#define read_shared_word64(place)     (*(volatile __global ulong*)(place))
#define write_shared_word(place, x)   (*(volatile __global uint*)(place) = (x))
#define write_shared_word64(place, x) (*(volatile __global ulong*)(place) = (x))
// no prefetch: while a work-item is waiting for memory, others run
#define FETCHES           0
#define fetch_soon(place) ((void)0)

// Rows of 8 and 4 floats. Reads bypass the first-level cache, which may lack changes by other compute units.
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
// Reads rows that no work-item changes during the kernel, through any cache.
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
INLINE void scatter_rows4(__global float* base, int index, const float in[4], int wanted)
{
	if (wanted)
		((ROW)base)[index] = (float4)(in[0], in[1], in[2], in[3]);
}

// one bound of eight packed boxes, read four at a time
typedef struct
{
	float of[8];
} Bound8;
INLINE Bound8 bound8(const __global float4* boxes, int which)
{
	Bound8 bound;
	row_parts(boxes[2 * which], boxes[2 * which + 1], bound.of);
	return bound;
}
#define bound_at(bound, k) ((bound).of[k])

#define LOADS_WAIT    1 // a work-item waits for a load before a later store, which might be to the same place
#define LOCAL         __local
#define group_lane()  ((int)get_local_id(0))
#define group_width() ((int)get_local_size(0))
#define part_lane()   group_lane()
#define part_width()  group_width()
#define group_meet()  barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE)
#define bench_meet()  barrier(CLK_LOCAL_MEM_FENCE)

// Defines an OpenCL kernel. specialize: code that may set members of pools.step to constants. Only every
// spread(items)-th work-item executes items, so that few long items do not share a warp. The parentheses around
// kernel_name prevent the expansion of a function-like macro of that name, such as store.
#define KERNEL_FUNCTION(kernel_name, name, specialize, spread)                                        \
	__kernel void(kernel_name)(POOL_ARGUMENTS Step step, Run run)                                     \
	{                                                                                                 \
		Pools pools = {POOL_NAMES step, run.argument};                                                \
		specialize;                                                                                   \
		int end = run.count < 0 ? run.end : min(run.end, ((__global int*)pools.counters)[run.count]); \
		int apart = spread(end - run.begin), by = (int)get_global_size(0) / apart;                    \
		if ((int)get_global_id(0) % apart == 0)                                                       \
			for (int i = run.begin + (int)get_global_id(0) / apart; i < end; i += by)                 \
				name##_item(&pools, i);                                                               \
	}
#define SPREAD_NOT(items) 1
#define KERNEL(name)                                 \
	INLINE void name##_item(const Pools* p, int i);  \
	KERNEL_FUNCTION(name, name, (void)0, SPREAD_NOT) \
	INLINE void name##_item(const Pools* p, int i)
#define WIDE_KERNEL(name) KERNEL(name)
#define LIST_KERNEL(name, list, length)                              \
	INLINE int name##_listed(const Pools* p, int i);                 \
	KERNEL(name)                                                     \
	{                                                                \
		int item = name##_listed(p, i);                              \
		if (item >= 0)                                               \
			p->list[atomic_add_int(&p->counters->length, 1)] = item; \
	}                                                                \
	INLINE int name##_listed(const Pools* p, int i)
#define GROUP_KERNEL(name)                                                                            \
	INLINE_MEET void name##_group(const Pools* p, int i, LOCAL float* bench);                         \
	__kernel void(name)(POOL_ARGUMENTS Step step, Run run)                                            \
	{                                                                                                 \
		__local float bench[GROUP_FLOATS];                                                            \
		Pools pools = {POOL_NAMES step, run.argument};                                                \
		int end = run.count < 0 ? run.end : min(run.end, ((__global int*)pools.counters)[run.count]); \
		for (int i = run.begin + (int)get_group_id(0); i < end; i += (int)get_num_groups(0))          \
			name##_group(&pools, i, bench);                                                           \
	}                                                                                                 \
	INLINE_MEET void name##_group(const Pools* p, int i, LOCAL float* bench)

#endif
