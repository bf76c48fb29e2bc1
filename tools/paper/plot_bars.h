// SPDX-License-Identifier: MIT
// plot_bars.h -- writes figure 6 as commands for gnuplot: share of each stage in a step.
#ifndef PLOT_BARS_H
#define PLOT_BARS_H
#include "tools/paper/table.h"
#include <stdio.h>

// Writes the commands: one plot for each scene, with a bar for each row.
void plot_bars(FILE* to, const Table* table);

#endif
