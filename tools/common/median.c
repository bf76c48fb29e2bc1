// SPDX-License-Identifier: MIT
// median.c -- sorts values and computes medians.
#include "tools/common/median.h"
#include <stdlib.h>

static int compare_values(const void* a, const void* b)
{
	double x = *(const double*)a, y = *(const double*)b;
	return (x > y) - (x < y);
}

static int compare_floats(const void* a, const void* b)
{
	float x = *(const float*)a, y = *(const float*)b;
	return (x > y) - (x < y);
}

void sort_values(double* values, int count) { qsort(values, (size_t)count, sizeof *values, compare_values); }
void sort_floats(float* values, int count) { qsort(values, (size_t)count, sizeof *values, compare_floats); }

double median_of(double* values, int count)
{
	sort_values(values, count);
	return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

double upper_median_of(double* values, int count)
{
	sort_values(values, count);
	return values[count / 2];
}
