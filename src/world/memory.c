// SPDX-License-Identifier: MIT
// memory.c -- enlarges arrays, and provides temporary memory for one call.
#include "world/memory.h"
#include "platform/error.h"
#include "world/world.h"
#include <limits.h>

void* world_scratch(scree_world* world, size_t bytes)
{
	if (bytes > world->scratch_bytes || !world->scratch)
	{
		void* memory = scree_allocate(bytes);
		if (!memory)
			return NULL;
		scree_release(world->scratch);
		world->scratch = memory;
		world->scratch_bytes = bytes;
	}
	return world->scratch;
}

scree_status grow(const char* function, void** array, int* capacity, size_t item, int needed)
{
	if (needed <= *capacity)
		return SCREE_OK;
	int64_t larger = *capacity + (int64_t)*capacity / 2 + 16;
	larger = larger > needed ? larger : needed;
	larger = larger < INT_MAX ? larger : INT_MAX;
	void* memory = scree_reallocate(*array, (size_t)*capacity * item, (size_t)larger * item);
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %lld items of %zu bytes", function, (long long)larger,
		            item);
	*array = memory;
	*capacity = (int)larger;
	return SCREE_OK;
}
