// SPDX-License-Identifier: MIT
// tables.c -- defines tables of the pools, kernels and kinds of constraints in pools.def, kernels.def and kinds.def.
#include "backend/tables.h"
#include "constraints/constraint_kinds.h"

// An engine without batches needs no names of their pools.
#ifdef SCREE_NO_BATCHES
#define NAMED(per) ((per) < PER_BAY || (per) > PER_COLUMN)
#else
#define NAMED(per) 1
#endif

// clang-format off
const PoolInfo pool_info[POOL_COUNT] = {
#define X(type, name, per, role) {NAMED(PER_##per) ? #name : "", sizeof(type), PER_##per, role},
#include "pools/pools.def"
#undef X
};

const char* const kernel_names[RUN_KINDS] = {
#define X(name, width, stage) #name,
#include "stages/kernels.def"
#undef X
	"sort",
	"scan",
};

const Width kernel_widths[KERNEL_COUNT] = {
#define X(name, width, stage) WIDTH_##width,
#include "stages/kernels.def"
#undef X
};

const Stage kernel_stages[KERNEL_COUNT] = {
#define X(name, width, stage) STAGE_##stage,
#include "stages/kernels.def"
#undef X
};

const KindInfo kind_info[CONSTRAINT_KINDS] = {
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                              \
	{.items = PER_##KIND,                                                                                              \
	 .places = PER_##KIND##_PLACE,                                                                                     \
	 .blocks = PER_##KIND##_BLOCK,                                                                                     \
	 .key = KERNEL_##kind##_key,                                                                                        \
	 .edge = KERNEL_##kind##_edge,                                                                                      \
	 .range = KERNEL_##kind##_range,                                                                                    \
	 .layout = KERNEL_##kind##_layout,                                                                                  \
	 .prepare = KERNEL_##kind##_prepare,                                                                                \
	 .prepare_rare = KERNEL_##kind##_prepare_rare,                                                                      \
	 .pass = {KERNEL_##kind##_warm_start, KERNEL_##kind##_bias, KERNEL_##kind##_relax, KERNEL_##kind##_bounce},            \
	 .hash = KERNEL_##kind##_hash},
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
};
// clang-format on

int kind_items(const Counters* counters, int kind)
{
	const int items[CONSTRAINT_KINDS] = {
#define CONSTRAINT_KIND(kind, Kind, KIND) counters->kind##s,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	};
	return items[kind];
}
