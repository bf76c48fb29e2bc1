// SPDX-License-Identifier: MIT
// median.h -- sorts values and computes medians.
#ifndef MEDIAN_H
#define MEDIAN_H

// Sorts values in ascending order.
void sort_values(double* values, int count);
void sort_floats(float* values, int count);

// Sorts at least one value, and returns the median. If the number of values is even, the median is the mean of the two
// in the middle.
double median_of(double* values, int count);

// Sorts at least one value, and returns the median. If the number of values is even, the median is the greater of the
// two in the middle, so that the result is always one of the values.
double upper_median_of(double* values, int count);

#endif
