// SPDX-License-Identifier: MIT
// run_list.h -- lists of runs: what a backend works through, one stage after the other.
#ifndef RUN_LIST_H
#define RUN_LIST_H
#include "pools/pools.h"
#include "scree/scree.h"

typedef struct // a list under construction
{
	Run* runs;
	int count, capacity;
} RunList;

// Empties a list and makes room for so many runs, so that adding them cannot fail.
scree_status runs_reserve(RunList* list, int capacity);
void runs_close(RunList* list);

// items begin to end, of which a counter may bound the end (COUNT, NO_COUNT)
void runs_add(RunList* list, int kernel, int begin, int end, int count, int argument);

// one item, for bookkeeping among the counters
void runs_add_single(RunList* list, int kernel);

// bits of the indices below count, as a sort key holds them: at least 1
int index_bits(int count);

// sorts items 0 to end by the bits from low up to, not including, high
void runs_add_sort(RunList* list, int end, int count, int low, int high);

#endif
