// SPDX-License-Identifier: MIT
// memory.h -- enlarges arrays, and provides temporary memory for one call.
#ifndef MEMORY_H
#define MEMORY_H
#include "scree/scree.h"
#include <stddef.h>

// Returns memory of at least the given size, or null if there is none. The next call of world_scratch may release it.
void* world_scratch(scree_world* world, size_t bytes);

// Enlarges an array to at least `needed` items, and at least by half, unless its capacity suffices. item: bytes per
// item.
scree_status grow(const char* function, void** array, int* capacity, size_t item, int needed);
#define GROW(function, array, capacity, needed) grow(function, (void**)&(array), &(capacity), sizeof *(array), needed)

#endif
