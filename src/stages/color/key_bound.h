// SPDX-License-Identifier: MIT
// key_bound.h -- where a key lies among sorted ones.
#ifndef KEY_BOUND_H
#define KEY_BOUND_H
#include "dialect/dialect.h"

// The first of the sorted keys from low up to high that is not less than key.
INLINE int key_bound(const GLOBAL Word64* keys, int low, int high, Word64 key)
{
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (keys[middle] < key)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

#endif
