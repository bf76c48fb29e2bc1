// SPDX-License-Identifier: MIT
// paper_cpu.c -- executes the first three stages on the CPU, in one thread, one item after the other.
#include "tools/paper/paper_cpu.h"
#include "tools/common/clock.h"

#define PAPER_STAGE(name)                                \
	INLINE void name##_item(const PaperPools* p, int i); \
	static void name(const PaperPools* p, int count)     \
	{                                                    \
		for (int i = 0; i < count; ++i)                  \
			name##_item(p, i);                           \
	}                                                    \
	INLINE void name##_item(const PaperPools* p, int i)

#include "tools/paper/paper_stages.h"

scree_status paper_cpu_run(Paper* paper)
{
	PaperPools* p = &paper->pools;
	double last = seconds_now(), now;
	*p->contact_count = 0;
#define X(name, items)                        \
	name(p, p->step.items);                   \
	now = seconds_now();                      \
	paper->timings.name = 1e3 * (now - last); \
	last = now;
	PAPER_STAGES(X)
#undef X
	if (*p->contact_count <= p->step.contact_capacity)
		return SCREE_OK;

	// The contact pool is too small. Detection can run again with a larger pool, because it changes only contacts.
	scree_status status = paper_reserve(paper, *p->contact_count);
	if (status != SCREE_OK)
		return status;
	*p->contact_count = 0;
	detect(p, p->step.collidables);
	paper->timings.detect += 1e3 * (seconds_now() - last);
	return SCREE_OK;
}
