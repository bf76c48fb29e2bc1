// SPDX-License-Identifier: MIT
// plot.c -- figures drawn by gnuplot (Debian: gnuplot-nox), which reads the CSV itself.
#include "plot.h"
#include "options.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void plot_mark(Plot* plot, double bodies, double ms, const char* name)
{
	if (plot->count == MAX_MARKS)
		return;
	plot->marks[plot->count].bodies = bodies;
	plot->marks[plot->count].ms = ms;
	plot->marks[plot->count++].name = name;
}

// one curve a pipeline and device: rows of others have no value there
static const char* const curve =
    "curve(p, gpu) = (strcol(1) eq p && (strcol(2)[1:6] eq 'opencl') == gpu) ? column(6) : NaN\n";

static void script_over(FILE* to, const Plot* plot)
{
	fputs(curve, to);
	fputs("set datafile missing NaN\nset grid\nset key left top Left reverse samplen 2\nset ylabel 'ms a step'\n"
	      "set xlabel 'bodies'\nset style data linespoints\nset multiplot layout 1, 2\n"
	      "set xrange [0:520]\nset yrange [0:*]\nset title 'as in the paper'\n",
	      to);
	const char* plotted = "plot csv every ::1 using 3:(curve('paper', 0)) title 'paper, CPU' lc 1 pt 6, \\\n"
	                      "     csv every ::1 using 3:(curve('paper', 1)) title 'paper, OpenCL' lc 2 pt 4, \\\n"
	                      "     csv every ::1 using 3:(curve('scree', 0)) title 'Scree, CPU' lc 3 pt 7, \\\n"
	                      "     csv every ::1 using 3:(curve('scree', 1)) title 'Scree, OpenCL' lc 4 pt 5\n";
	fputs(plotted, to);
	fputs("set logscale xy\nset xrange [10:2e6]\nset yrange [*:*]\nset format x '10^{%L}'\nunset key\n"
	      "set title 'on to a million; crossovers marked'\n",
	      to);
	for (int k = 0; k < plot->count; ++k)
		fprintf(to, "set label %d '%s: %.0f' at %g, %g point pt 2 ps 2 offset 1, -1\n", k + 1, plot->marks[k].name,
		        plot->marks[k].bodies, plot->marks[k].bodies, plot->marks[k].ms);
	fputs(plotted, to);
	fputs("unset multiplot\n", to);
}

// A bar a row of the CSV, its stages on top of each other as shares of their sum.
static void script_shares(FILE* to)
{
	fputs("set style data histograms\nset style histogram rowstacked\nset style fill solid 0.8 border -1\n"
	      "set boxwidth 0.8\nset yrange [0:100]\nset ylabel 'share of the stages, %'\nset grid y\n"
	      "set xtics rotate by -20 noenhanced\nset key outside right Left reverse invert noenhanced\n"
	      "set key autotitle columnheader\nset linetype 9 lc rgb '#888888'\nset linetype 10 lc rgb '#a0522d'\n"
	      "set linetype 11 lc rgb '#c0c0ff'\n"
	      "total(dummy) = sum [k=7:17] column(k)\n"
	      "plot for [k=7:17] csv using (100 * column(k) / total(0)):xtic(strcol(1).', '.strcol(2)[1:6].', '.strcol(3)) "
	      "lt k - 6\n",
	      to);
}

int plot_figure(const Plot* plot, const char* name)
{
	if (system("command -v gnuplot >/dev/null 2>&1") != 0)
	{
		fprintf(stderr, "scree bench: %s.csv is not drawn, because there is no gnuplot (Debian: gnuplot-nox)\n", name);
		return EXIT_GOOD;
	}
	static const char* const terminals[][2] = {{"svg", "svg size 1100,450 background 'white'"},
	                                           {"png", "pngcairo size 2200,900 fontscale 1.6 linewidth 2"}};
	for (int k = 0; k < 2; ++k)
	{
		FILE* to = popen("gnuplot", "w");
		if (!to)
			return EXIT_FAILED;
		fprintf(to, "csv = '%s.csv'\nset datafile separator ','\nset terminal %s\nset output '%s.%s'\n", name,
		        terminals[k][1], name, terminals[k][0]);
		if (strcmp(name, "figure5") == 0)
			script_over(to, plot);
		else
			script_shares(to);
		if (pclose(to) != 0)
		{
			fprintf(stderr, "scree bench: gnuplot could not draw %s.csv\n", name);
			return EXIT_FAILED;
		}
	}
	printf("%s.csv, %s.svg and %s.png are written\n", name, name, name);
	return EXIT_GOOD;
}
