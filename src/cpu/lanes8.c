// SPDX-License-Identifier: MIT
// lanes8.c -- the wide stages, eight items a call: AVX2 on x86.
#define LANES 8
#include "stages/chain.h"
#include "stages/hub.h"
#include "stages/integrate.h"
#include "stages/narrow_phase_keep.h"
#include "stages/prepare.h"
#include "stages/solve.h"
#include "stages/taut.h"
#include "stages/tree_code.h"

#include "cpu/table.h"
