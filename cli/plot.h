// SPDX-License-Identifier: MIT
// plot.h -- figures drawn by gnuplot, as SVG and PNG.
#ifndef PLOT_H
#define PLOT_H

#define MAX_MARKS 8

typedef struct
{
	struct
	{
		double bodies, ms;
		const char* name; // of the pipeline
	} marks[MAX_MARKS];
	int count;
} Plot;

// Marks where OpenCL becomes faster than the CPU.
void plot_mark(Plot* plot, double bodies, double ms, const char* name);

// Draws NAME.csv (figure5 or figure6) into NAME.svg and NAME.png. Returns an exit code; without gnuplot it says that there
// are no plots, and all is well.
int plot_figure(const Plot* plot, const char* name);

#endif
