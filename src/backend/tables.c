// SPDX-License-Identifier: MIT
// tables.c -- what pools.def, stages.def and kinds.def list, as tables.
#include "backend/tables.h"
#include "constraints/constraint_kinds.h"

// clang-format off
const PoolInfo pool_info[POOL_COUNT] = {
#define X(type, name, per, role) {#name, sizeof(type), PER_##per, role},
#include "pools/pools.def"
#undef X
};

const char* const stage_names[RUN_KINDS] = {
#define X(name, width, box) #name,
#include "stages/stages.def"
#undef X
	"sort",
	"scan",
};

const Width stage_widths[STAGE_COUNT] = {
#define X(name, width, box) WIDTH_##width,
#include "stages/stages.def"
#undef X
};

const Box stage_boxes[STAGE_COUNT] = {
#define X(name, width, box) BOX_##box,
#include "stages/stages.def"
#undef X
};

const KindInfo kind_info[CONSTRAINT_KINDS] = {
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                              \
	{.items = PER_##KIND,                                                                                              \
	 .places = PER_##KIND##_PLACE,                                                                                     \
	 .blocks = PER_##KIND##_BLOCK,                                                                                     \
	 .key = STAGE_##kind##_key,                                                                                        \
	 .edge = STAGE_##kind##_edge,                                                                                      \
	 .range = STAGE_##kind##_range,                                                                                    \
	 .layout = STAGE_##kind##_layout,                                                                                  \
	 .prepare = STAGE_##kind##_prepare,                                                                                \
	 .prepare_rare = STAGE_##kind##_prepare_rare,                                                                      \
	 .pass = {STAGE_##kind##_warm_start, STAGE_##kind##_bias, STAGE_##kind##_relax, STAGE_##kind##_bounce},            \
	 .hash = STAGE_##kind##_hash},
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
