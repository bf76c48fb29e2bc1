// SPDX-License-Identifier: MIT
// tables.c -- what pools.def and stages.def list, as tables.
#include "backend/backend.h"
#include "constraints/kinds.h"

// clang-format off
const PoolInfo pool_info[POOL_COUNT] = {
#define X(type, name, per, role) {#name, sizeof(type), per, role},
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
