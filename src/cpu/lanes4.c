// SPDX-License-Identifier: MIT
// lanes4.c -- the wide stages, four items a call: SSE2 or NEON.
#define LANES 4
#ifndef SCREE_SMALL
#include "stages/chain.h"
#include "stages/hub.h"
#endif
#include "stages/integrate.h"
#include "stages/narrow_phase_keep.h"
#include "stages/prepare.h"
#include "stages/solve.h"
#include "stages/taut.h"
#include "stages/tree_code.h"

#include "cpu/table.h"
