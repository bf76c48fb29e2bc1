// SPDX-License-Identifier: MIT
// pools.h -- the pools in pools.def, as C and OpenCL C read them. The types are in the other headers of this folder.
#ifndef POOLS_H
#define POOLS_H
#include "pools/body_types.h"
#include "pools/chain_types.h"
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
