// SPDX-License-Identifier: MIT
// lanes16.c -- the wide stages, sixteen items a call: AVX-512 on x86.
#define LANES 16
#include "stages/chain.h"
#include "stages/hub.h"
#include "stages/integrate.h"
#include "stages/narrow_phase_keep.h"
#include "stages/prepare.h"
#include "stages/solve.h"
#include "stages/taut.h"
#include "stages/tree_code.h"

#include "cpu/table.h"
