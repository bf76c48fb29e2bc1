// SPDX-License-Identifier: MIT
// constraint_kinds.h -- includes all kinds of constraints, and generates functions from their rows.
#ifndef CONSTRAINT_KINDS_H
#define CONSTRAINT_KINDS_H
#include "constraints/contact_constraint.h"
#include "constraints/joint_pass.h"
#include "dialect/hash_word.h"

// Expands ROW (constraint.h) for each row of constraint i, or for each rare row.
#define EACH_ROW(kind, Kind, KIND, ROW)                           \
	{                                                             \
		GLOBAL Kind##Rows* rows = p->kind##_rows + i / MAX_LANES; \
		int lane = i % MAX_LANES;                                 \
		(void)rows, (void)lane;                                   \
		KIND##_ROWS(ROW)                                          \
	}
#define EACH_RARE_ROW(kind, Kind, KIND, ROW)                               \
	{                                                                      \
		GLOBAL Kind##RareRows* rows = p->kind##_rare_rows + i / MAX_LANES; \
		int lane = i % MAX_LANES;                                          \
		(void)rows, (void)lane;                                            \
		KIND##_RARE_ROWS(ROW)                                              \
	}

// Loads the rows of constraint i that a pass reads, and stores the rows that the pass writes.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                       \
	INLINE void kind##_load(const Pools* p, int i, int pass, Kind* u) { EACH_ROW(kind, Kind, KIND, ROW_LOAD); } \
	INLINE void kind##_store(const Pools* p, int i, int pass, const Kind* u) { EACH_ROW(kind, Kind, KIND, ROW_STORE); }
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// For forms of the solve that keep constraints in registers over a step: load_all loads the rows that passes read,
// except prepared ones; store_kept stores the kept rows that passes write.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                     \
	INLINE void kind##_load_all(const Pools* p, int i, Kind* u) { EACH_ROW(kind, Kind, KIND, ROW_LOAD_ALL); } \
	INLINE void kind##_store_kept(const Pools* p, int i, const Kind* u) { EACH_ROW(kind, Kind, KIND, ROW_STORE_KEPT); }
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// Writes padding: place i gets the slot -1 and an inert constraint, whose two bodies are body 0.
#define CONSTRAINT_KIND(kind, Kind, KIND)         \
	INLINE void kind##_pad(const Pools* p, int i) \
	{                                             \
		p->kind##_place_slot[i] = -1;             \
		kind##_row(p, body_a, i) = 0;             \
		kind##_row(p, body_b, i) = 0;             \
		EACH_ROW(kind, Kind, KIND, ROW_PAD);      \
		EACH_RARE_ROW(kind, Kind, KIND, ROW_PAD); \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// For a new layout: keep copies the kept rows of place i to the slot, put_back from the slot to the new place i. forget
// clears the kept values of a slot; fetch_kept prefetches the kept rows of place i.
#define CONSTRAINT_KIND(kind, Kind, KIND)                              \
	INLINE void kind##_keep(const Pools* p, int slot, int i)           \
	{                                                                  \
		{                                                              \
			Kind##Kept kept;                                           \
			EACH_ROW(kind, Kind, KIND, ROW_KEEP);                      \
			p->kind##_kept[slot] = kept;                               \
		}                                                              \
		{                                                              \
			Kind##RareKept kept;                                       \
			EACH_RARE_ROW(kind, Kind, KIND, ROW_KEEP);                 \
			p->kind##_rare_kept[slot] = kept;                          \
		}                                                              \
	}                                                                  \
	INLINE void kind##_put_back(const Pools* p, int slot, int i)       \
	{                                                                  \
		{                                                              \
			Kind##Kept kept = p->kind##_kept[slot];                    \
			EACH_ROW(kind, Kind, KIND, ROW_PUT_BACK);                  \
		}                                                              \
		{                                                              \
			Kind##RareKept kept = p->kind##_rare_kept[slot];           \
			EACH_RARE_ROW(kind, Kind, KIND, ROW_PUT_BACK);             \
		}                                                              \
	}                                                                  \
	INLINE void kind##_forget(const Pools* p, int slot)                \
	{                                                                  \
		const Kind##Kept none = {0};                                   \
		const Kind##RareKept rare_none = {0};                          \
		p->kind##_kept[slot] = none;                                   \
		p->kind##_rare_kept[slot] = rare_none;                         \
	}                                                                  \
	INLINE void kind##_fetch_kept(const Pools* p, int i)               \
	{                                                                  \
		EACH_ROW(kind, Kind, KIND, ROW_FETCH);                         \
		EACH_RARE_ROW(kind, Kind, KIND, ROW_FETCH);                    \
	}                                                                  \
	/* Hashes the kept values of place i, in the order of the rows. */ \
	INLINE Word64 kind##_hash_kept(Word64 h, const Pools* p, int i)    \
	{                                                                  \
		EACH_ROW(kind, Kind, KIND, ROW_HASH);                          \
		EACH_RARE_ROW(kind, Kind, KIND, ROW_HASH);                     \
		return h;                                                      \
	}                                                                  \
	/* Hashes the kept values of a slot in the same order. */          \
	INLINE Word64 kind##_hash_slot(Word64 h, const Pools* p, int slot) \
	{                                                                  \
		{                                                              \
			const GLOBAL Kind##Kept* kept = p->kind##_kept + slot;     \
			KIND##_ROWS(ROW_HASH_SLOT)(void) kept;                     \
		}                                                              \
		{                                                              \
			const GLOBAL Kind##RareKept* kept;                         \
			kept = p->kind##_rare_kept + slot;                         \
			KIND##_RARE_ROWS(ROW_HASH_SLOT)(void) kept;                \
		}                                                              \
		return h;                                                      \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// Returns whether the layout contains spokes. The bodies that are their hubs depend on masses and numbers of joints too, so
// a change of these needs a new layout, which copies of the world also have.
INLINE int layout_has_spokes(const GLOBAL Counters* c) { return c->layout[CONSTRAINT_CONTACT].count[COLORS] > 0; }

#endif
