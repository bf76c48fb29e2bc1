// SPDX-License-Identifier: MIT
// program.h -- all stages, in order; read by lanes1.c, one8.c and the OpenCL program.
// clang-format off
#include "dialect/dialect.h"
#include "pools/pools.h"
#include "dialect/vec.h"
#include "dialect/finite.h"
#include "constraints/kinds.h"
#include "stages/edge.h"
#include "stages/touch.h"
SMALL_BEGIN
#include "stages/command.h"
SMALL_END
#include "stages/transform.h"
#include "stages/tree.h"
#include "stages/broad_phase.h"
#include "stages/joint.h"
#include "stages/rule.h"
#include "stages/contact.h"
#include "stages/narrow_phase.h"
SMALL_BEGIN
#include "stages/hub_one.h"
#include "stages/press.h"
SMALL_END
#include "stages/color.h"
SMALL_BEGIN
#include "stages/field.h"
#include "stages/prepare_one.h"
SMALL_END
#include "stages/prepare.h"
#include "stages/integrate.h"
#include "stages/solve.h"
SMALL_BEGIN
#include "stages/taut.h"
#include "stages/overflow.h"
#include "stages/chain.h"
#include "stages/branch.h"
SMALL_END
#include "stages/hub.h"
#include "stages/guard.h"
#include "stages/finalize.h"
SMALL_BEGIN
#include "stages/ask.h"
#include "stages/listed.h"
#include "stages/event.h"
#include "stages/query.h"
#include "stages/sense.h"
#include "stages/told.h"
#include "stages/joint_show.h"
#include "stages/hash.h"
SMALL_END
