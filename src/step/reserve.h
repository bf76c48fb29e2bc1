// SPDX-License-Identifier: MIT
// reserve.h -- capacities of the pools: they grow when a stage needs more, and shrink after long disuse.
#ifndef RESERVE_H
#define RESERVE_H
#include "step/pipeline_state.h"

#define LEAST_CAPACITY 64 // items: the capacity of a pool is a multiple of it

// Reserves capacity items, growing by at least half, for the pools of a kind and all that depend on it.
scree_status pipeline_reserve(Pipeline* pipeline, Per per, int capacity);

// Shrinks pools that have been much too large for a long time. Called after a step.
void pipeline_trim(Pipeline* pipeline);

// Counts the step. Returns whether few of the contact slots have been used for a long time.
bool pipeline_sparse(Pipeline* pipeline);

#endif
