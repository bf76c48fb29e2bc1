// SPDX-License-Identifier: MIT
// tables.h -- what pools.def, kernels.def and kinds.def list, as enumerators and tables.
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
	// Not stages: each backend has its own implementation, with equal results. SORT: sorts items 0 to end of
	// pool key by the bits from argument & 255 up to, not including, argument >> 8; stable.
	PRIMITIVE_SORT = KERNEL_COUNT,
	// SCAN: replaces items 0 to end of pool scan by the sum of the items before each.
	PRIMITIVE_SCAN,
	RUN_KINDS
} KernelId;

typedef enum // how many lanes process an item of a stage
{
	WIDTH_ONE,
	WIDTH_WIDE,  // one call processes as many items as there are lanes
	WIDTH_ALONE, // as WIDTH_ONE, for what is rare or on request: the persistent kernel of OpenCL does without it
	WIDTH_GROUP, // a worker, or a group of work-items; its lanes share the item
	WIDTH_TEAM,  // the same, but that a worker does it with one lane
} Width;

typedef enum // the stages of the step
{
	STAGE_transform,
	STAGE_broad_phase,
	STAGE_narrow_phase,
	STAGE_color,
	STAGE_solve,
	STAGE_finalize,
	STAGE_COUNT
} Stage;

typedef struct // of pools.def, in order
{
	const char* name;
	size_t bytes; // an item
	Per per;
	Role role;
} PoolInfo;
extern const PoolInfo pool_info[POOL_COUNT];

typedef struct // of a kind of constraint
{
	Per items, places, blocks;
	KernelId key, edge, range, layout; // which lay it out
	KernelId prepare, prepare_rare, pass[PASS_KINDS], hash;
} KindInfo;
extern const KindInfo kind_info[CONSTRAINT_KINDS];

// slots in use of a kind
int kind_items(const Counters* counters, int kind);

extern const char* const kernel_names[RUN_KINDS];
extern const Stage kernel_stages[KERNEL_COUNT];
extern const Width kernel_widths[KERNEL_COUNT];

// Run.count of a member of Counters
#define COUNT(member) ((int)(offsetof(Counters, member) / sizeof(int)))
#define NO_COUNT      (-1)

#endif
