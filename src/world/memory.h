// SPDX-License-Identifier: MIT
// memory.h -- arrays that grow, and temporary memory for one call.
#ifndef MEMORY_H
#define MEMORY_H
#include "scree/scree.h"
#include <stddef.h>

// Returns at least the given number of bytes, valid until the next call; null if there is no memory.
void* world_scratch(scree_world* world, size_t bytes);

// Enlarges an array of *capacity items, by half at least, if it is smaller than needed.
scree_status grow(const char* function, void** array, int* capacity, size_t item, int needed);
#define GROW(function, array, capacity, needed) grow(function, (void**)&(array), &(capacity), sizeof *(array), needed)

#endif
