// SPDX-License-Identifier: MIT
// allocations.c -- an allocator that fails when a test requests it.
#include "support/allocations.h"
#include <stdlib.h>
#include <string.h>

int allocations_left;
size_t largest_allocation;
bool shortage_passes;

static void* limited_allocate(size_t bytes, size_t alignment, void* context)
{
	(void)context;
	if (allocations_left == 0 || bytes > largest_allocation)
	{
		allocations_left -= allocations_left == 0 && shortage_passes;
		return NULL;
	}
	allocations_left -= allocations_left > 0;
#ifdef _WIN32
	return _aligned_malloc(bytes, alignment);
#else
	return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
#endif
}

static void plain_release(void* memory, void* context)
{
	(void)context;
#ifdef _WIN32
	_aligned_free(memory);
#else
	free(memory);
#endif
}

void count_allocations(void)
{
	const scree_hooks hooks = {.allocate = limited_allocate, .release = plain_release};
	allocations_left = -1;
	largest_allocation = SIZE_MAX;
	shortage_passes = false;
	OK(scree_hooks_set(&hooks));
}

void end_of_shortage(scree_status status)
{
	assert_int_equal(status, SCREE_ERROR_OUT_OF_MEMORY);
	assert_non_null(strstr(scree_error(), "memory"));
	allocations_left = -1;
}
