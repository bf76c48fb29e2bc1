// SPDX-License-Identifier: MIT
// run_list.c -- builds lists of runs, which a backend executes in order.
#include "backend/run_list.h"
#include "backend/tables.h"
#include "platform/error.h"

scree_status runs_reserve(RunList* list, int capacity)
{
	list->count = 0;
	if (capacity <= list->capacity)
		return SCREE_OK;
	Run* runs = scree_reallocate(list->runs, 0, sizeof(Run) * (size_t)capacity);
	if (!runs)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for a list of %d runs", capacity);
	list->runs = runs;
	list->capacity = capacity;
	return SCREE_OK;
}

void runs_close(RunList* list) { scree_release(list->runs); }

void runs_add(RunList* list, int kernel, int begin, int end, int count, int argument)
{
	ASSERT(list->count < list->capacity);
	list->runs[list->count++] =
	    (Run){.kernel_id = kernel, .begin = begin, .end = end, .count = count, .argument = argument};
}

void runs_add_single(RunList* list, int kernel) { runs_add(list, kernel, 0, 1, NO_COUNT, 0); }

void runs_add_sort(RunList* list, int end, int count, int low, int high)
{
	runs_add(list, PRIMITIVE_SORT, 0, end, count, RUN_PAIR(low, high));
}

int index_bits(int count)
{
	int bits = 1;
	while (bits < 31 && 1 << bits < count)
		++bits;
	return bits;
}
