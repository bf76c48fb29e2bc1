// SPDX-License-Identifier: MIT
// experiment_support.h -- memory for experiments, beside what all programs share.
#ifndef EXPERIMENT_SUPPORT_H
#define EXPERIMENT_SUPPORT_H
#include "tools/common/median.h"
#include "tools/common/random_numbers.h"

// Returns memory that was allocated. If it is null, ends the program with a sentence.
void* require_memory(void* memory);

#endif
