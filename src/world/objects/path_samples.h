// SPDX-License-Identifier: MIT
// path_samples.h -- computes the samples of a path: a smooth curve through points.
#ifndef PATH_SAMPLES_H
#define PATH_SAMPLES_H
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>

// Number of samples per span, from one point to the next. Cubics between the samples add an error: on a circle through
// 8 points, (angle between samples)^4 / 384 = 2.4e-7 of the radius. The spline itself has an error of 1.2e-3.
#define PATH_SHARES 8

static inline int path_spans(int points, bool closed) { return points - !closed; }

// Returns the number of doubles that path_sample needs as work memory.
static inline size_t path_work(int points) { return (size_t)points * 8; }

// Writes PATH_SHARES samples for each span, and one for the last point. Each point must differ from the next one.
void path_sample(const scree_vec* points, int count, bool closed, double* work, PathSample* samples);

#endif
