// SPDX-License-Identifier: MIT
// run_list.h -- lists of runs: the kernels that a backend executes in order.
#ifndef RUN_LIST_H
#define RUN_LIST_H
#include "pools/pools.h"
#include "scree/scree.h"

typedef struct // a list under construction
{
	Run* runs;
	int count, capacity;
} RunList;

// Empties a list, and makes its capacity large enough, so that adding runs cannot fail.
scree_status runs_reserve(RunList* list, int capacity);
void runs_close(RunList* list);

// Adds a run over items begin to end - 1; a counter may bound the end (COUNT, NO_COUNT).
void runs_add(RunList* list, int kernel, int begin, int end, int count, int argument);
void runs_add_single(RunList* list, int kernel);

// Returns the bits of the indices below count in a sort key, at least 1.
int index_bits(int count);

// Adds a sort of items 0 to end by the bits from low up to, not including, high.
void runs_add_sort(RunList* list, int end, int count, int low, int high);

#endif
