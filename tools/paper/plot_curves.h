// SPDX-License-Identifier: MIT
// plot_curves.h -- writes figure 5 as commands for gnuplot: time of a step over the number of bodies.
#ifndef PLOT_CURVES_H
#define PLOT_CURVES_H
#include "tools/paper/table.h"
#include <stdio.h>

// Writes the commands: two plots for each scene, the left one up to the sizes of the paper, the right one up to a
// million bodies.
void plot_curves(FILE* to, const Table* table);

#endif
