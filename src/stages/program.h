// SPDX-License-Identifier: MIT
// program.h -- all stages, in order; read by lanes1.c, one8.c and the OpenCL program.
// clang-format off
#include "stages/dialect.h"
#include "pools/pools.h"
#include "stages/vec.h"
#include "stages/command.h"
#include "stages/transform.h"
#include "stages/tree.h"
#include "stages/broad_phase.h"
#include "stages/contact.h"
#include "stages/narrow_phase.h"
#include "stages/hub_one.h"
#include "stages/color.h"
#include "stages/solve_one.h"
#include "stages/solve.h"
#include "stages/hub.h"
#include "stages/finalize.h"
#include "stages/hash.h"
