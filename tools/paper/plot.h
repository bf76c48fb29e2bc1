// SPDX-License-Identifier: MIT
// plot.h -- draws the figures of scree_paper from their CSV with gnuplot.
#ifndef PLOT_H
#define PLOT_H

// Draws the CSV of figure 5 or 6 (number) as SVG and PNG files beside it. Prints the crossovers of figure 5. Without
// gnuplot the function draws nothing, prints a message and does not fail. Returns an exit code.
int plot_figure(const char* csv, int number);

#endif
