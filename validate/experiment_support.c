// SPDX-License-Identifier: MIT
// experiment_support.c -- memory, medians and random numbers for experiments.
#include "experiment_support.h"
#include <stdio.h>
#include <stdlib.h>

static int rising(const void* a, const void* b)
{
	double x = *(const double*)a, y = *(const double*)b;
	return (x > y) - (x < y);
}

double median_of_values(double* values, int count)
{
	qsort(values, (size_t)count, sizeof *values, rising);
	return values[count / 2];
}

void* require_memory(void* memory)
{
	if (memory)
		return memory;
	fprintf(stderr, "scree validate: out of memory\n");
	exit(1);
}

double random_between(uint64_t* seed, double low, double high)
{
	uint64_t z = *seed += 0x9e3779b97f4a7c15u;
	z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
	z = (z ^ z >> 27) * 0x94d049bb133111ebu;
	return low + (high - low) * (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}
