// SPDX-License-Identifier: MIT
// experiment_support.h -- memory, medians and random numbers for experiments.
#ifndef EXPERIMENT_SUPPORT_H
#define EXPERIMENT_SUPPORT_H
#include <stdint.h>

// Returns memory that was allocated. If it is null, ends the program with a sentence.
void* require_memory(void* memory);

// The middle one of values. Sorts the values.
double median_of_values(double* values, int count);

// The same numbers on every machine, by Sebastiano Vigna, splitmix64, 2015.
double random_between(uint64_t* seed, double low, double high);

#endif
