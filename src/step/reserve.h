// SPDX-License-Identifier: MIT
// reserve.h -- capacities of the pools: they grow when a stage needs more, and shrink after long disuse.
#ifndef RESERVE_H
#define RESERVE_H
#include "step/pipeline_state.h"

#define LEAST_CAPACITY 64 // items: a pool has a multiple of it

// Gives a kind of pool and those that follow it (constraints with contacts, leaves and nodes with collidables, ...)
// room for at least capacity items; grows by half at least.
scree_status pipeline_reserve(Pipeline* pipeline, Per per, int capacity);

// After a step: shrinks pools that have long been much too large.
void pipeline_trim(Pipeline* pipeline);

// Counts the step. Returns whether for long few of the contact slots have been in use.
bool pipeline_sparse(Pipeline* pipeline);

#endif
