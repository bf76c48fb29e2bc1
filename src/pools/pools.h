// SPDX-License-Identifier: MIT
// pools.h -- declares the pools of pools.def for C and OpenCL C. The other headers of this folder declare their types.
#ifndef POOLS_H
#define POOLS_H
#include "pools/body_types.h"
#include "pools/chain_types.h"
#include "pools/channel_types.h"
#include "pools/collidable_types.h"
#include "pools/command_types.h"
#include "pools/contact_types.h"
#include "pools/device_counters.h"
#include "pools/field_types.h"
#include "pools/joint_types.h"
#include "pools/query_types.h"
#include "pools/step_types.h"

typedef struct
{
#define X(type, name, per, role) GLOBAL type* name;
#include "pools/pools.def"
#undef X
	Step step;
	int argument;
} Pools;

#endif
