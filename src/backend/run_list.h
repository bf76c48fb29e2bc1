// SPDX-License-Identifier: MIT
// run_list.h -- builds lists of runs, which a backend executes in order.
#ifndef RUN_LIST_H
#define RUN_LIST_H
#include "pools/pools.h"
#include "scree/scree.h"

typedef struct // a list of runs under construction
{
	Run* runs;
	int count, capacity;
} RunList;

// Empties a list and reserves capacity for runs, so that adding runs cannot fail.
scree_status runs_reserve(RunList* list, int capacity);
void runs_close(RunList* list);

// Adds a run over items begin to end - 1. count: counter on the device (COUNT) that limits the end, or NO_COUNT.
void runs_add(RunList* list, int kernel, int begin, int end, int count, int argument);
void runs_add_single(RunList* list, int kernel);

// Returns the number of bits that an index below `count` takes in a sort key, at least 1.
int index_bits(int count);

// Adds a sort of items 0 to end - 1 by bits low to high - 1 of their keys. count: as for runs_add.
void runs_add_sort(RunList* list, int end, int count, int low, int high);

#endif
