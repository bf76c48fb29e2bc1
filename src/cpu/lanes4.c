// SPDX-License-Identifier: MIT
// lanes4.c -- compiles the wide kernels for four items per call: SSE2 or NEON.
#define LANES 4
#ifndef SCREE_SMALL
#include "stages/batch/bay_leaf.h"
#include "stages/batch/channel_angles.h"
#include "stages/broad_phase/transform_wide.h"
#include "stages/finalize/finalize_wide.h"
#include "stages/save/saved_collidables.h"
#include "stages/save/saved_contact.h"
#include "stages/solve/chain/chain.h"
#include "stages/solve/hub/hub.h"
#endif
#include "stages/narrow_phase/manifold_reuse.h"
#include "stages/solve/integrate.h"
#include "stages/solve/prepare.h"
#include "stages/solve/solve_pass.h"
#include "stages/solve/taut.h"
#include "stages/tree/hilbert.h"

#include "cpu/kernel_table.h"
