// SPDX-License-Identifier: MIT
// plot.h -- draws the figures of scree_paper from their CSV, with gnuplot.
#ifndef PLOT_H
#define PLOT_H

// Draws the CSV of figure5_command or figure6_command (number 5 or 6) as SVG and PNG beside it, and prints the crossovers of
// figure 5. Returns an exit code. Without gnuplot it prints that nothing is drawn, which is no failure.
int plot_figure(const char* csv, int number);

#endif
