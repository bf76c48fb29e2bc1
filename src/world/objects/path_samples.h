// SPDX-License-Identifier: MIT
// path_samples.h -- computes the samples of a path: a smooth curve through points.
#ifndef PATH_SAMPLES_H
#define PATH_SAMPLES_H
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>

// Samples per span, from one point to the next. The cubics between samples deviate by angle^4 / 384 of the radius of a
// circle: 2.4e-7 if 8 points make a full circle. The curve through these points itself deviates by 1.2e-3.
#define PATH_SHARES 8

static inline int path_spans(int points, bool closed) { return points - !closed; }

// Returns the number of doubles in the work memory of path_sample.
static inline size_t path_work(int points) { return (size_t)points * 8; }

// Writes PATH_SHARES samples of each span, and the last one. Neighboring points must differ.
void path_sample(const scree_vec* points, int count, bool closed, double* work, PathSample* samples);

#endif
