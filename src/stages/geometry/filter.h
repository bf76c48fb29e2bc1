// SPDX-License-Identifier: MIT
// filter.h -- tests whether the filters and kinds of two collidables let them touch, at any poses.
#ifndef FILTER_H
#define FILTER_H
#include "pools/pools.h"

INLINE int filter_accepts(Filter a, Filter b)
{
	if (a.group != 0 && a.group == b.group)
		return a.group > 0;
	return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

// Returns whether two kinds may have a contact: one is dynamic or has no body, and none is a sensor or dead.
INLINE int kinds_meet(int a, int b)
{
	if ((a | b) & KIND_SENSOR || a == KIND_DEAD || b == KIND_DEAD)
		return 0;
	return a == KIND_DYNAMIC || b == KIND_DYNAMIC || a == KIND_FREE || b == KIND_FREE;
}

#endif
