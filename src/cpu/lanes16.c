// SPDX-License-Identifier: MIT
// lanes16.c -- compiles the wide kernels for sixteen items per call: AVX-512 on x86.
#define LANES 16
#include "stages/batch/bay_leaf.h"
#include "stages/batch/channel_angles.h"
#include "stages/broad_phase/transform_wide.h"
#include "stages/finalize/finalize_wide.h"
#include "stages/narrow_phase/manifold_reuse.h"
#include "stages/save/saved_collidables.h"
#include "stages/save/saved_contact.h"
#include "stages/solve/chain/chain.h"
#include "stages/solve/hub/hub.h"
#include "stages/solve/integrate.h"
#include "stages/solve/prepare.h"
#include "stages/solve/solve_pass.h"
#include "stages/solve/taut.h"
#include "stages/tree/hilbert.h"

#include "cpu/kernel_table.h"
