// SPDX-License-Identifier: MIT
// different_pools.h -- reads items of pools, and prints the pools in which two worlds differ.
#ifndef DIFFERENT_POOLS_H
#define DIFFERENT_POOLS_H
#include "backend/tables.h"
#include "support/checks.h"

// Reads the items 0 to count - 1 of a pool into a new array, which the caller frees.
void* read_pool(scree_world* world, PoolId pool, int count);

// Prints the names of the pools in which two worlds differ, each with the first item that differs.
void print_different_pools(scree_world* a, scree_world* b);

#endif
