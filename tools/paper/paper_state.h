// SPDX-License-Identifier: MIT
// paper_state.h -- declares the state of the paper's pipeline, which all its files use.
#ifndef PAPER_STATE_H
#define PAPER_STATE_H
#include "scree/scree.h"
#include "tools/paper/paper_counters.h"
#include "tools/paper/paper_pools.h"
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

typedef struct // memory of a pool on the host
{
	void* memory;
	size_t bytes;
} PaperMemory;

typedef struct Paper
{
	PaperPools pools; // pools on the host
	PaperCounters counters;
	PaperTimings timings;
	char device[160];
	struct PaperOpenCl* opencl; // null on the CPU
	void* scratch;              // memory that resolve.c keeps between steps
	size_t scratch_bytes;
} Paper;

// Returns the memory of a pool on the host.
PaperMemory paper_memory(const Paper* paper, PaperPoolId pool);

// Allocates the contact pool of the host, with room for 1.5 times the needed contacts. The old contents are lost.
scree_status paper_reserve(Paper* paper, int needed);

#endif
