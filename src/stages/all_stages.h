// SPDX-License-Identifier: MIT
// all_stages.h -- includes all stages in the order of dependencies, for lanes1.c, scalar_avx2.c and the OpenCL program.
// clang-format off
#include "dialect/dialect.h"
#include "pools/pools.h"
#include "dialect/vec.h"
#include "dialect/finite.h"
#include "constraints/constraint_kinds.h"
#include "stages/color/edge.h"
#include "stages/color/touch.h"
SMALL_BEGIN
#include "stages/edit/command.h"
SMALL_END
#include "stages/broad_phase/transform.h"
#include "stages/tree/tree.h"
#include "stages/broad_phase/leaf.h"
#include "stages/broad_phase/broad_phase.h"
SMALL_BEGIN
#include "stages/color/joint_edges.h"
#include "stages/rules/rule.h"
#include "stages/broad_phase/contact_slots.h"
SMALL_END
#include "stages/narrow_phase/narrow_phase.h"
SMALL_BEGIN
#include "stages/sleep/wake.h"
#include "stages/solve/hub/hub_one.h"
#include "stages/solve/press.h"
SMALL_END
#include "stages/color/color.h"
SMALL_BEGIN
#include "stages/field/field_forces.h"
#include "stages/solve/prepare_one.h"
SMALL_END
#include "stages/solve/prepare.h"
#include "stages/solve/integrate.h"
#include "stages/solve/solve_pass.h"
SMALL_BEGIN
#include "stages/solve/taut.h"
#include "stages/solve/overflow.h"
#include "stages/solve/chain/chain.h"
#include "stages/solve/chain/branch.h"
#include "stages/solve/hub/hub.h"
SMALL_END
SMALL_BEGIN
#include "stages/finalize/continuous.h"
SMALL_END
#include "stages/finalize/finalize.h"
SMALL_BEGIN
#include "stages/finalize/contact_approval.h"
#include "stages/read/contact_report.h"
#include "stages/read/event.h"
#include "stages/read/query.h"
#include "stages/read/sensor.h"
#include "stages/read/moved_bodies.h"
#include "stages/read/interpolate.h"
#include "stages/read/joint_report.h"
#include "stages/read/hash.h"
#include "stages/save/tidy.h"
#ifndef SCREE_NO_BATCHES
#include "stages/batch/bay_edit.h"
#include "stages/batch/bay_hash.h"
#include "stages/batch/layout_patch.h"
#include "stages/batch/channel_output.h"
#include "stages/batch/channel_angles.h"
#endif
#ifndef SCREE_SMALL
#include "stages/batch/bay_leaf.h"
#include "stages/finalize/finalize_wide.h"
#endif
SMALL_END
