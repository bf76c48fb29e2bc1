// SPDX-License-Identifier: MIT
// key_bound.h -- finds a key among sorted keys by binary search.
#ifndef KEY_BOUND_H
#define KEY_BOUND_H
#include "dialect/dialect.h"

// Returns the index, from `low` on, of the first key that is not less than `key`; `high` if all keys below it are less.
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
