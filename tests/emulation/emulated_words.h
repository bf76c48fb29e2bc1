// SPDX-License-Identifier: MIT
// emulated_words.h -- defines words of OpenCL C that C17 lacks, by calls of work_items.h. Files include it before the
// kernels.
//
// The stages come from stage_items.h. Here their groups have more than one work-item.
#ifndef EMULATION_EMULATED_WORDS_H
#define EMULATION_EMULATED_WORDS_H
#include "emulation/work_items.h"
#include "support/checks.h"

#include "support/stage_items.h"

// adds items to a list with an atomic counter, as a device does
#undef LIST_KERNEL
#define LIST_KERNEL(name, list, length)                              \
	INLINE int name##_listed(const Pools* p, int i);                 \
	INLINE void name##_item(const Pools* p, int i)                   \
	{                                                                \
		int item = name##_listed(p, i);                              \
		if (item >= 0)                                               \
			p->list[atomic_add_int(&p->counters->length, 1)] = item; \
	}                                                                \
	INLINE int name##_listed(const Pools* p, int i)

// TILE_BODIES is so small that a small world has several tiles. TILE_GROUP is larger than the number of colors, because
// a group needs more work-items than there are colors.
#define TILE_BODIES 16
#define TILE_GROUP  80

// BAY_GROUP is smaller than the number of columns, and than that of the constraints of most columns.
#define BAY_BODIES 40
#define BAY_GROUP  12

// PRIMITIVE_GROUP and the sizes of a sort are so small that a small sort has several groups and passes.
#define PRIMITIVE_GROUP 32
#define SORT_DIGIT_BITS 5
#define SORT_GRAIN      64
#define SORT_FEW        32
#define SORT_TEAM       8

#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wold-style-declaration" // `volatile static` would give this warning
#endif
// PAUSE and FETCH_AHEAD are empty here, which would give the first of these warnings
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-variable"

// Work-items of a group share its memory: work_items.c copies the memory of the group that has the turn into this
// section.
#define __local static __attribute__((section("group_memory")))
#define __global
#define __kernel                      static __attribute__((unused))
#define reqd_work_group_size(x, y, z) unused

typedef unsigned char uchar;
typedef unsigned int uint;
typedef unsigned long ulong;
typedef Float2 float2;
typedef Float4 float4;
typedef WordPair ulong2;

#define min(a, b)   ((a) < (b) ? (a) : (b))
#define max(a, b)   ((a) > (b) ? (a) : (b))
#define popcount(x) __builtin_popcountll(x)
#define as_int(x)   float_bits(x)
#define as_uint(x)  float_word(x)
#define as_float(x) bits_float((int)(x))

#define get_local_id(x)    ((size_t)items_lane())
#define get_local_size(x)  ((size_t)items_group_size())
#define get_group_id(x)    ((size_t)items_group())
#define get_num_groups(x)  ((size_t)items_groups())
#define get_global_id(x)   (get_group_id(x) * get_local_size(x) + get_local_id(x))
#define get_global_size(x) (get_num_groups(x) * get_local_size(x))

#define barrier(memory)      items_meet(__FILE__, __LINE__)
#define atomic_add(place, x) (items_yield(), __atomic_fetch_add(place, x, __ATOMIC_RELAXED))
#define atomic_inc(place)    atomic_add(place, 1)
#define atomic_or(place, x)  (items_yield(), __atomic_fetch_or(place, x, __ATOMIC_RELAXED))
#define atomic_min(place, x) (items_yield(), *(place) = min(*(place), x))
#define DEVICE_FENCE()       items_yield()
#define read_shared(place)   (items_yield(), *(volatile int*)(place))

#undef group_lane
#undef group_width
#undef group_meet
#undef bench_meet
#undef part_lane
#undef part_width
#define group_lane()  items_lane()
#define group_width() items_group_size()
#define part_lane()   group_lane()
#define part_width()  group_width()
#define group_meet()  barrier(0)
#define bench_meet()  barrier(0)

#define MAILBOX_READ(row)                 items_look(row)
#define MAILBOX_WRITE(row, first, second) items_put(row, (WordPair){(first), (second)})

// passes the pools as one struct; tests/CMakeLists.txt makes POOL_NAMES from src/pools/pools.def
#define POOL_ARGUMENTS const Pools *given,
#include "emulation/pool_names.h"

#endif
