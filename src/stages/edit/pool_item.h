// SPDX-License-Identifier: MIT
// pool_item.h -- hashes, clears, moves or prefetches an item in all of its pools; roles select the pools.
#ifndef POOL_ITEM_H
#define POOL_ITEM_H
#include "constraints/constraint_kinds.h"
#include "pools/hash_types.h"
#include "pools/roles.h"

#define HASH_HASHED(x) x
#define HASH_STATE(x)
#define HASH_STANDING(x)
#define HASH_DERIVED(x)
#define HASH_SCRATCH(x)

// Adds an item to a hash. `per` is a constant in all calls of these functions, so the compiler removes all other pools.
INLINE Word64 item_hash(const Pools* p, Per per, int i, Word64 h, Origin origin)
{
#define X(type, name, of, role) HASH_##role(if (per == PER_##of) h = hash_##type(h, p->name[i]);)
#include "pools/pools.def"
#undef X
	(void)origin;
	return h;
}

// Rows of four floats that contain a value of the type, and whether it consists of whole rows.
#define ITEM_ROWS(type) ((int)((sizeof(type) + sizeof(Float4) - 1) / sizeof(Float4)))
#define IN_ROWS(type)   (sizeof(type) % sizeof(Float4) == 0)

// Clears a new item. OpenCL C does not accept {0} for a vector, so the zero comes from the second member of a struct,
// which is zero by default.
INLINE void item_clear(const Pools* p, Per per, int i)
{
#define X(type, name, of, role)           \
	if (per == PER_##of && role <= STATE) \
	{                                     \
		const struct                      \
		{                                 \
			int first;                    \
			type zero;                    \
		} value = {0};                    \
		p->name[i] = value.zero;          \
	}
#include "pools/pools.def"
#undef X
}

// Moves an item. With LOADS_WAIT all values are loaded before the first one is stored, so that a GPU waits once for all of them, and
// values that fill rows of four floats move row by row, because a GPU would transfer each of their members alone. The structs are zero
// for the same reason as in item_clear.
INLINE void item_move(const Pools* p, Per per, int to, int from)
{
#if LOADS_WAIT
#define X(type, name, of, role)                                          \
	struct name##_rows                                                   \
	{                                                                    \
		Float4 rows[ITEM_ROWS(type)];                                    \
	};                                                                   \
	struct                                                               \
	{                                                                    \
		int first;                                                       \
		type value;                                                      \
		struct name##_rows rows;                                         \
	} name = {0};                                                        \
	if (per == PER_##of && role <= STANDING && IN_ROWS(type))            \
		name.rows = *(const GLOBAL struct name##_rows*)(p->name + from); \
	else if (per == PER_##of && role <= STANDING)                        \
		name.value = p->name[from];
#include "pools/pools.def"
#undef X
#define X(type, name, of, role)                                  \
	if (per == PER_##of && role <= STANDING && IN_ROWS(type))    \
		*(GLOBAL struct name##_rows*)(p->name + to) = name.rows; \
	else if (per == PER_##of && role <= STANDING)                \
		p->name[to] = name.value;
#include "pools/pools.def"
#undef X
#else
#define X(type, name, of, role)              \
	if (per == PER_##of && role <= STANDING) \
		p->name[to] = p->name[from];
#include "pools/pools.def"
#undef X
#endif
}

INLINE void item_fetch(const Pools* p, Per per, int i)
{
#define X(type, name, of, role)           \
	if (per == PER_##of && role <= STATE) \
		fetch_soon(p->name + i);
#include "pools/pools.def"
#undef X
	(void)p;
	(void)per;
	(void)i;
}

#endif
