// SPDX-License-Identifier: MIT
// support.h -- memory, medians and random numbers for experiments.
#ifndef SUPPORT_H
#define SUPPORT_H
#include <stdint.h>

// Returns memory that was allocated. If it is null, ends the program with a sentence.
void* require_memory(void* memory);

// The middle one of values. Sorts the values.
double median_of_values(double* values, int count);

// The same numbers on every machine, by Sebastiano Vigna, splitmix64, 2015.
double random_between(uint64_t* seed, double low, double high);

#endif
