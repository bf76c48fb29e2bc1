// SPDX-License-Identifier: MIT
// tables.h -- declares enumerators and tables of the pools, kernels and kinds in pools.def, kernels.def and kinds.def.
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
	// Primitives, implemented by each backend with equal results. SORT: sorts items 0 to end - 1 of the pool `key`,
	// stably, by bits low to high - 1 of the key. The run's argument contains low (RUN_LOW) and high (RUN_HIGH).
	PRIMITIVE_SORT = KERNEL_COUNT,
	PRIMITIVE_SCAN, // replaces each of items 0 to end - 1 of the pool `scan` by the sum of the items before it
	RUN_KINDS
} KernelId;

enum // number of buffers that contain all pools of an OpenCL device
{
#define SHARES(kind, with) -1
	BUFFERS = PER_COUNT
#include "pools/buffers.def"
#undef SHARES
};

typedef enum // the lanes or work-items that process an item of a kernel
{
	WIDTH_ONE,
	WIDTH_WIDE,       // one lane per item; a call processes an item in each lane
	WIDTH_ALONE,      // as WIDTH_ONE, for rare kernels; from here on, not in OpenCL's persistent kernel
	WIDTH_WIDE_ALONE, // as WIDTH_WIDE, for rare kernels; one lane in WebAssembly, for less code
	WIDTH_GROUP,      // a worker or a work-group processes an item; its lanes share the item
	WIDTH_TEAM,       // as WIDTH_GROUP, but a worker uses only one lane
} Width;

typedef enum // stages of the step
{
#define X(name) STAGE_##name,
#include "stages/stages.def"
#undef X
	STAGE_COUNT
} Stage;

typedef struct // an entry of pools.def; the table has the order of the file
{
	const char* name;
	size_t bytes; // size of an item
	Per per;
	Role role;
} PoolInfo;
extern const PoolInfo pool_info[POOL_COUNT];

typedef struct // pools and kernels of one kind of constraint
{
	Per items, places, blocks;
	KernelId key, edge, range, layout; // kernels that compute the layout of its constraints
	KernelId prepare, prepare_rare, pass[PASS_KINDS], hash;
} KindInfo;
extern const KindInfo kind_info[CONSTRAINT_KINDS];

// Returns the number of slots of a kind of constraint, up to the last slot in use.
int kind_items(const Counters* counters, int kind);

extern const char* const kernel_names[RUN_KINDS];
extern const Stage kernel_stages[KERNEL_COUNT];
extern const Width kernel_widths[KERNEL_COUNT];

// Returns the value of Run.count that selects a member of Counters.
#define COUNT(member) ((int)(offsetof(Counters, member) / sizeof(int)))
#define NO_COUNT      (-1)

#endif
