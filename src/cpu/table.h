// SPDX-License-Identifier: MIT
// table.h -- the end of each lanesN.c and of one8.c: the table of the stages compiled above.
#include "cpu/lanes.h"

#ifndef TABLE
#define TABLE STAGE_JOIN(stages, LANES)
#endif

#if LANES == 1
#define ENTRY_ONE(name) STAGE_JOIN(name, LANES)
#else
#define ENTRY_ONE(name) NULL
#endif
#define ENTRY_ALONE(name) ENTRY_ONE(name)
#define ENTRY_WIDE(name)  STAGE_JOIN(name, LANES)
#define ENTRY_GROUP(name) STAGE_JOIN(name, LANES)

// clang-format off
const StageFunction TABLE[STAGE_COUNT] = {
#define X(name, width, box) ENTRY_##width(name),
#include "stages/stages.def"
#undef X
};
