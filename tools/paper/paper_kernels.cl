// SPDX-License-Identifier: MIT
// paper_kernels.cl -- defines the OpenCL kernels of the paper's pipeline: one for each stage, with a work-item for each
// item.
#include "tools/paper/paper_pools.h"

#define ARGUMENT(type, name, items) __global type* name,
#define NAME(type, name, items) name,
#define PAPER_STAGE(name)                                                  \
	INLINE void name##_item(const PaperPools* p, int i);                   \
	__kernel void name(PAPER_POOLS(ARGUMENT) PaperStep step, int count)    \
	{                                                                      \
		PaperPools pools = {PAPER_POOLS(NAME) step};                       \
		int i = (int)get_global_id(0);                                     \
		if (i < count)                                                     \
			name##_item(&pools, i);                                        \
	}                                                                      \
	INLINE void name##_item(const PaperPools* p, int i)

#include "tools/paper/paper_stages.h"
