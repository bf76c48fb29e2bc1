// SPDX-License-Identifier: MIT
// plot_curves.h -- figure 5 for gnuplot: time of a step over the number of bodies.
#ifndef PLOT_CURVES_H
#define PLOT_CURVES_H
#include "tools/paper/table.h"
#include <stdio.h>

// Writes commands for gnuplot: two plots a scene, left up to the sizes of the paper, right up to a million bodies.
void plot_curves(FILE* to, const Table* table);

#endif
