// SPDX-License-Identifier: MIT
// c_words.h -- defines the dialect in C, except the parts that depend on the number of lanes; included by dialect.h.
#ifndef C_WORDS_H
#define C_WORDS_H
#include "platform/exact_floats.h"
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
INLINE int lowest_bit(Word64 x) { return __builtin_ctzll(x); }
#define square_root(x) __builtin_sqrtf(x)
#define quotient(a, b) ((a) / (b))

// one bound of eight packed boxes
typedef const float* Bound8;
#define bound8(boxes, which) (&(boxes)[2 * (which)].x)
#define bound_at(bound, k)   ((bound)[k])

#define FETCHES           1
#define fetch_soon(place) __builtin_prefetch(place)

#define gather_fixed_rows8(base, index, out) gather_rows8(base, index, out)

// Operations on numbers that several threads use at once. WebAssembly without threads has plain ones, which are smaller.
// SHARED_EXCHANGE(place, old, x): stores x and returns 1 if *place is *old, else sets *old to *place; may fail without reason.
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
#define SHARED_LOAD(place)             (*(place))
#define SHARED_STORE(place, x)         (*(place) = (x))
#define SHARED_ADD(place, x, order)    ((*(place) += (x)) - (x))
#define SHARED_AND(place, x)           (*(place) &= (x))
#define SHARED_OR(place, x)            (*(place) |= (x))
#define SHARED_EXCHANGE(place, old, x) (*(place) = (x), 1)
#else
#define SHARED_LOAD(place)             __atomic_load_n(place, __ATOMIC_RELAXED)
#define SHARED_STORE(place, x)         __atomic_store_n(place, x, __ATOMIC_RELAXED)
#define SHARED_ADD(place, x, order)    __atomic_fetch_add(place, x, order)
#define SHARED_AND(place, x)           __atomic_fetch_and(place, x, __ATOMIC_RELAXED)
#define SHARED_OR(place, x)            __atomic_fetch_or(place, x, __ATOMIC_RELAXED)
#define SHARED_EXCHANGE(place, old, x) __atomic_compare_exchange_n(place, old, x, 1, __ATOMIC_RELAXED, __ATOMIC_RELAXED)
#endif
INLINE int atomic_add_int(int* place, int x) { return SHARED_ADD(place, x, __ATOMIC_RELAXED); }
INLINE int arrive_int(int* place) { return SHARED_ADD(place, 1, __ATOMIC_ACQ_REL); }
INLINE void atomic_and_word64(Word64* place, Word64 x) { SHARED_AND(place, x); }
INLINE int read_shared(int* place) { return SHARED_LOAD(place); }
INLINE Word read_shared_word(Word* place) { return SHARED_LOAD(place); }
INLINE Word64 read_shared_word64(Word64* place) { return SHARED_LOAD(place); }
INLINE void write_shared_word(Word* place, Word x) { SHARED_STORE(place, x); }
INLINE void write_shared_word64(Word64* place, Word64 x) { SHARED_STORE(place, x); }
INLINE int atomic_max_int(int* place, int x) // returns the old value
{
	int old = read_shared(place);
	while (old < x && !SHARED_EXCHANGE(place, &old, x))
	{
	}
	return old;
}
INLINE int atomic_min_int(int* place, int x) // returns the old value
{
	int old = read_shared(place);
	while (old > x && !SHARED_EXCHANGE(place, &old, x))
	{
	}
	return old;
}
INLINE void atomic_or_int(int* place, int x) { SHARED_OR(place, x); }
INLINE void atomic_max_word(Word* place, Word x)
{
	Word old = read_shared_word(place);
	while (old < x && !SHARED_EXCHANGE(place, &old, x))
	{
	}
}
#ifndef LANES
#define LANES 1
#endif

// Rows of 8 and 4 floats for one lane; transpose.h has the functions for several lanes.
#if LANES == 1
INLINE void gather_rows8(const float* base, int index, float out[8]) { memcpy(out, base + 8 * (size_t)index, 32); }
INLINE void store_rows8(float* base, int first, const float in[8]) { memcpy(base + 8 * (size_t)first, in, 32); }
INLINE void load_rows4(const float* base, int first, float out[4]) { memcpy(out, base + 4 * (size_t)first, 16); }
INLINE void store_rows4(float* base, int first, const float in[4]) { memcpy(base + 4 * (size_t)first, in, 16); }
INLINE void scatter_rows4of8(float* base, int index, const float in[4], int wanted)
{
	if (wanted)
		memcpy(base + 8 * (size_t)index, in, 16);
}
INLINE void scatter_rows4(float* base, int index, const float in[4], int wanted)
{
	if (wanted)
		memcpy(base + 4 * (size_t)index, in, 16);
}
#endif

#define LOADS_WAIT 0
#define LOCAL
#define group_lane()  0
#define group_width() LANES
#define part_lane()   0
#define part_width()  1
#define group_meet()
#define bench_meet()

#define KERNEL_JOIN_(name, lanes) name##_lanes##lanes
#define KERNEL_JOIN(name, lanes)  KERNEL_JOIN_(name, lanes)
#define KERNEL(name)                                                         \
	INLINE void name##_item(const Pools* p, int i);                          \
	static void KERNEL_JOIN(name, LANES)(const Pools* p, int begin, int end) \
	{                                                                        \
		for (int i = begin; i < end; i += LANES)                             \
			name##_item(p, i);                                               \
	}                                                                        \
	INLINE void name##_item(const Pools* p, int i)
#define WIDE_KERNEL(name) KERNEL(name)
#define LIST_KERNEL(name, list, length)                                                                              \
	INLINE int name##_listed(const Pools* p, int i);                                                                 \
	static void KERNEL_JOIN(name, LANES)(const Pools* p, int begin, int end)                                         \
	{                                                                                                                \
		int found[CHUNK_ITEMS], count = 0;                                                                           \
		for (int i = begin; i < end; ++i)                                                                            \
		{                                                                                                            \
			int item = name##_listed(p, i);                                                                          \
			found[count] = item;                                                                                     \
			count += item >= 0;                                                                                      \
			if (count < CHUNK_ITEMS && i + 1 < end)                                                                  \
				continue;                                                                                            \
			if (count > 0)                                                                                           \
				memcpy(p->list + atomic_add_int(&p->counters->length, count), found, (size_t)count * sizeof *found); \
			count = 0;                                                                                               \
		}                                                                                                            \
	}                                                                                                                \
	INLINE int name##_listed(const Pools* p, int i)
// WIDE_LIST_KERNEL(name, list, length): as LIST_KERNEL for several lanes. The code stores the items in `found` and
// returns their number.
#define WIDE_LIST_KERNEL(name, list, length)                                                                         \
	INLINE int name##_listed(const Pools* p, int i, int* found);                                                     \
	static void KERNEL_JOIN(name, LANES)(const Pools* p, int begin, int end)                                         \
	{                                                                                                                \
		int found[CHUNK_ITEMS], count = 0;                                                                           \
		for (int i = begin; i < end; i += LANES)                                                                     \
		{                                                                                                            \
			count += name##_listed(p, i, found + count);                                                             \
			if (count <= CHUNK_ITEMS - LANES && i + LANES < end)                                                     \
				continue;                                                                                            \
			if (count > 0)                                                                                           \
				memcpy(p->list + atomic_add_int(&p->counters->length, count), found, (size_t)count * sizeof *found); \
			count = 0;                                                                                               \
		}                                                                                                            \
	}                                                                                                                \
	INLINE int name##_listed(const Pools* p, int i, int* found)
#define GROUP_KERNEL(name)                                                   \
	INLINE void name##_group(const Pools* p, int i, float* bench);           \
	static void KERNEL_JOIN(name, LANES)(const Pools* p, int begin, int end) \
	{                                                                        \
		_Alignas(64) float bench[GROUP_FLOATS];                              \
		for (int i = begin; i < end; ++i)                                    \
			name##_group(p, i, bench);                                       \
	}                                                                        \
	INLINE void name##_group(const Pools* p, int i, float* bench)

#endif
