// SPDX-License-Identifier: MIT
// experiment_support.h -- ends an experiment when memory is short; includes the headers that all experiments use.
#ifndef EXPERIMENT_SUPPORT_H
#define EXPERIMENT_SUPPORT_H
#include "tools/common/median.h"
#include "tools/common/random_numbers.h"

// Returns `memory`, the result of an allocation. If it is null, prints a message and ends the program.
void* require_memory(void* memory);

#endif
