// SPDX-License-Identifier: MIT
// plot_bars.h -- figure 6 for gnuplot: share of each stage in a step.
#ifndef PLOT_BARS_H
#define PLOT_BARS_H
#include "tools/paper/table.h"
#include <stdio.h>

// Writes commands for gnuplot: one plot a scene, with a bar for each row.
void plot_bars(FILE* to, const Table* table);

#endif
