// SPDX-License-Identifier: MIT
// kinds.h -- all kinds of constraints, and the functions generated from their rows.
#ifndef KINDS_H
#define KINDS_H
#include "constraints/contact.h"

// The rows of constraint i that a pass reads, and writes.
#define CONSTRAINT_KIND(kind, Kind, KIND)                               \
	INLINE void kind##_load(const Pools* p, int i, int pass, Kind* u)   \
	{                                                                   \
		const GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES; \
		int lane = i % MAX_LANES;                                       \
		KIND##_ROWS(ROW_LOAD)                                           \
	}                                                                   \
	INLINE void kind##_store(const Pools* p, int i, int pass, Kind* u)  \
	{                                                                   \
		GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES;       \
		int lane = i % MAX_LANES;                                       \
		KIND##_ROWS(ROW_STORE)                                          \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// For forms of the solve that keep constraints in registers over a step: all rows that are not prepared, and at the end
// the kept ones.
#define CONSTRAINT_KIND(kind, Kind, KIND)                               \
	INLINE void kind##_take(const Pools* p, int i, Kind* u)             \
	{                                                                   \
		const GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES; \
		int lane = i % MAX_LANES;                                       \
		KIND##_ROWS(ROW_TAKE)                                           \
	}                                                                   \
	INLINE void kind##_stow(const Pools* p, int i, const Kind* u)       \
	{                                                                   \
		GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES;       \
		int lane = i % MAX_LANES;                                       \
		KIND##_ROWS(ROW_STOW)                                           \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// Padding: place i gets an inert constraint between the ground and itself.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                      \
	INLINE void kind##_pad(const Pools* p, int i)                              \
	{                                                                          \
		int lane = i % MAX_LANES;                                              \
		p->kind##_place_slot[i] = -1;                                          \
		kind##_row(p, body_a, i) = 0;                                          \
		kind##_row(p, body_b, i) = 0;                                          \
		{                                                                      \
			GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES;          \
			KIND##_ROWS(ROW_PAD)                                               \
		}                                                                      \
		{                                                                      \
			GLOBAL Kind##RareRows* rows = p->kind##_rare_rows + i / MAX_LANES; \
			KIND##_RARE_ROWS(ROW_PAD)                                          \
		}                                                                      \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// While constraints are laid out, their kept rows are copied from the old place to a slot, and from there to the new
// place.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                            \
	INLINE void kind##_keep(const Pools* p, int slot, int i)                         \
	{                                                                                \
		int lane = i % MAX_LANES;                                                    \
		{                                                                            \
			const GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES;          \
			Kind##Kept kept;                                                         \
			KIND##_ROWS(ROW_KEEP) p->kind##_kept[slot] = kept;                       \
		}                                                                            \
		{                                                                            \
			const GLOBAL Kind##RareRows* rows = p->kind##_rare_rows + i / MAX_LANES; \
			Kind##RareKept kept;                                                     \
			KIND##_RARE_ROWS(ROW_KEEP) p->kind##_rare_kept[slot] = kept;             \
		}                                                                            \
	}                                                                                \
	INLINE void kind##_put_back(const Pools* p, int slot, int i)                     \
	{                                                                                \
		int lane = i % MAX_LANES;                                                    \
		{                                                                            \
			GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES;                \
			Kind##Kept kept = p->kind##_kept[slot];                                  \
			KIND##_ROWS(ROW_PUT_BACK)                                                \
		}                                                                            \
		{                                                                            \
			GLOBAL Kind##RareRows* rows = p->kind##_rare_rows + i / MAX_LANES;       \
			Kind##RareKept kept = p->kind##_rare_kept[slot];                         \
			KIND##_RARE_ROWS(ROW_PUT_BACK)                                           \
		}                                                                            \
	}                                                                                \
	/* A new item has nothing to keep. */                                            \
	INLINE void kind##_forget(const Pools* p, int slot)                              \
	{                                                                                \
		{                                                                            \
			Kind##Kept kept;                                                         \
			KIND##_ROWS(ROW_FORGET) p->kind##_kept[slot] = kept;                     \
		}                                                                            \
		{                                                                            \
			Kind##RareKept kept;                                                     \
			KIND##_RARE_ROWS(ROW_FORGET) p->kind##_rare_kept[slot] = kept;           \
		}                                                                            \
	}                                                                                \
	/* What is kept of place i is fetched from memory. */                            \
	INLINE void kind##_fetch_kept(const Pools* p, int i)                             \
	{                                                                                \
		int lane = i % MAX_LANES;                                                    \
		{                                                                            \
			GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES;                \
			KIND##_ROWS(ROW_FETCH)                                                   \
		}                                                                            \
		{                                                                            \
			GLOBAL Kind##RareRows* rows = p->kind##_rare_rows + i / MAX_LANES;       \
			KIND##_RARE_ROWS(ROW_FETCH)                                              \
		}                                                                            \
		(void)lane;                                                                  \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
