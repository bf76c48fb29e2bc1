// SPDX-License-Identifier: MIT
// filter.h -- which collidables may touch, wherever they are.
#ifndef FILTER_H
#define FILTER_H
#include "pools/pools.h"

INLINE int filter_accepts(Filter a, Filter b)
{
	if (a.group != 0 && a.group == b.group)
		return a.group > 0;
	return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

// one of the two must be able to move, or be made for detection; a sensor touches nothing, and nothing touches what is disabled
INLINE int kinds_meet(int a, int b)
{
	if ((a | b) & KIND_SENSOR || a == KIND_DEAD || b == KIND_DEAD)
		return 0;
	return a == KIND_DYNAMIC || b == KIND_DYNAMIC || a == KIND_FREE || b == KIND_FREE;
}

#endif
