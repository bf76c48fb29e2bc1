// SPDX-License-Identifier: MIT
// state.h -- what the files of the paper's pipeline share.
#ifndef REFERENCE_STATE_H
#define REFERENCE_STATE_H
#include "reference/paper.h"
#include "reference/pools.h"
#include <stddef.h>

typedef enum
{
#define X(type, name, items) PAPER_POOL_##name,
	PAPER_POOLS(X)
#undef X
	    PAPER_POOL_COUNT
} PaperPoolId;

typedef enum
{
#define X(name, items) PAPER_STAGE_##name,
	PAPER_STAGES(X)
#undef X
	    PAPER_STAGE_COUNT
} PaperStageId;

typedef struct // a pool of the host as plain memory
{
	void* memory;
	size_t bytes;
} PaperMemory;

struct Paper
{
	PaperPools pools; // on the host
	PaperCounters counters;
	PaperTimings timings;
	char device[160];
	struct PaperOpenCl* opencl; // null on the CPU
	void* scratch;              // of resolve
	size_t scratch_bytes;
};

PaperMemory paper_memory(const Paper* paper, PaperPoolId pool);

// Gives the contact pool of the host room for needed contacts. What it held is lost.
scree_status paper_reserve(Paper* paper, int needed);

// reference/import.c: fills the pools from a world.
scree_status paper_take(Paper* paper, scree_world* world);

// Run the first three stages. The contacts lie in the pool of the host, in any order.
scree_status paper_cpu_run(Paper* paper);
scree_status paper_opencl_run(Paper* paper);

// part: of a device's name, null for any
scree_status paper_opencl_open(Paper* paper, const char* part, bool allow_unequal_bits);
void paper_opencl_close(Paper* paper);

// reference/resolve.c: the fourth stage. The contacts are sorted.
scree_status paper_resolve(Paper* paper);

#endif
