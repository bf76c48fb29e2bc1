// SPDX-License-Identifier: MIT
// paper_state.c -- accesses and grows the pools of the paper's pipeline.
#include "tools/paper/paper_state.h"
#include "platform/error.h"

_Static_assert(sizeof(PaperCollidable) == 224 && sizeof(PaperBody) == 80 && sizeof(PaperContact) == 64,
               "OpenCL C must find the members where C put them");

PaperMemory paper_memory(const Paper* paper, PaperPoolId pool)
{
	const PaperStep* step = &paper->pools.step;
	const PaperMemory all[] = {
#define X(type, name, items) {paper->pools.name, (size_t)(items) * sizeof(type)},
		PAPER_POOLS(X)
#undef X
	};
	return all[pool];
}

scree_status paper_reserve(Paper* paper, int needed)
{
	int64_t capacity = (int64_t)needed + needed / 2;
	PaperContact* larger = scree_allocate((size_t)capacity * sizeof *larger);
	if (!larger || capacity > INT32_MAX)
	{
		scree_release(larger);
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "paper_step: no memory for %d contacts", needed);
	}
	scree_release(paper->pools.contact);
	paper->pools.contact = larger;
	paper->pools.step.contact_capacity = (int)capacity;
	return SCREE_OK;
}
