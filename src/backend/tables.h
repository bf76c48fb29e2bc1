// SPDX-License-Identifier: MIT
// tables.h -- enumerators and tables of pools.def, kernels.def and kinds.def.
#ifndef TABLES_H
#define TABLES_H
#include "constraints/schedule.h"
#include "pools/pools.h"
#include "pools/roles.h"
#include <stddef.h>

typedef enum
{
#define X(type, name, per, role) POOL_##name,
#include "pools/pools.def"
#undef X
	POOL_COUNT
} PoolId;

typedef enum
{
#define X(name, width, stage) KERNEL_##name,
#include "stages/kernels.def"
#undef X
	KERNEL_COUNT,
	// Primitives, not kernels: each backend has its own implementation, with equal results. SORT: sorts items 0
	// to end of pool key, stably, by the bits from RUN_LOW of argument up to, not including, RUN_HIGH.
	PRIMITIVE_SORT = KERNEL_COUNT,
	PRIMITIVE_SCAN, // replaces items 0 to end of pool scan by the sum of the items before each
	RUN_KINDS
} KernelId;

typedef enum // number of lanes that process an item of a kernel
{
	WIDTH_ONE,
	WIDTH_WIDE,  // one call processes as many items as there are lanes
	WIDTH_ALONE, // as WIDTH_ONE, for rare kernels and those on request, which OpenCL's persistent kernel leaves out
	WIDTH_GROUP, // a worker, or a work-group, whose lanes share the item
	WIDTH_TEAM,  // the same, except that a worker uses one lane
} Width;

typedef enum // the stages of the step
{
#define X(name) STAGE_##name,
#include "stages/stages.def"
#undef X
	STAGE_COUNT
} Stage;

typedef struct // entry of pools.def, in order
{
	const char* name;
	size_t bytes; // size of an item
	Per per;
	Role role;
} PoolInfo;
extern const PoolInfo pool_info[POOL_COUNT];

typedef struct // pools and kernels of a kind of constraint
{
	Per items, places, blocks;
	KernelId key, edge, range, layout; // kernels that lay it out
	KernelId prepare, prepare_rare, pass[PASS_KINDS], hash;
} KindInfo;
extern const KindInfo kind_info[CONSTRAINT_KINDS];

// Returns the number of slots of a kind up to the last one in use.
int kind_items(const Counters* counters, int kind);

extern const char* const kernel_names[RUN_KINDS];
extern const Stage kernel_stages[KERNEL_COUNT];
extern const Width kernel_widths[KERNEL_COUNT];

// Returns the value of Run.count for a member of Counters.
#define COUNT(member) ((int)(offsetof(Counters, member) / sizeof(int)))
#define NO_COUNT      (-1)

#endif
