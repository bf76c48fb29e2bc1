// SPDX-License-Identifier: MIT
// median.h -- sorted values and their median.
#ifndef MEDIAN_H
#define MEDIAN_H

// Sorts values, the least first.
void sort_values(double* values, int count);
void sort_floats(float* values, int count);

// The median of at least one value, of an even count the mean of the two in the middle. Sorts the values.
double median_of(double* values, int count);

// The same, but of an even count the greater of the two in the middle, so that it is one of the values.
double upper_median_of(double* values, int count);

#endif
