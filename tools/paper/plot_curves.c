// SPDX-License-Identifier: MIT
// plot_curves.c -- writes figure 5 as commands for gnuplot: time of a step over the number of bodies.
#include "tools/paper/plot_curves.h"
#include "tools/paper/plot_text.h"
#include <math.h>

#define AXIS 560 // number of bodies at the end of the axis in left plots; a little more than the paper's 500

#define CURVES 5
static const struct
{
	int pipeline;
	FigurePlace place;
} curves[CURVES] = {{0, ON_ONE_THREAD}, {0, ON_OPENCL}, {1, ON_ONE_THREAD}, {1, ON_THREADS}, {1, ON_OPENCL}};

// colors that color-blind readers can distinguish: Okabe, Ito, Color Universal Design, 2008
#define CURVE_COLORS "array color[5] = ['#d55e00', '#e69f00', '#56b4e9', '#0072b2', '#009e73']\n"
// labels of the time axis; positions are in ms
#define TIMES "set ytics ('1 µs' 1e-3, '10 µs' 1e-2, '0.1 ms' 0.1, '1 ms' 1, '10 ms' 10, '0.1 s' 100, '1 s' 1e3)\n"
#define LONG_TIMES \
	"set ytics ('10 µs' 1e-2, '1 ms' 1, '0.1 s' 100, '10 s' 1e4, '17 min' 1e6, '1.2 days' 1e8, '116 days' 1e10)\n"

static const Row* curve_next(const Table* table, const Row* after, int scene, int curve)
{
	return table_next(table, after, scene, curves[curve].pipeline, curves[curve].place);
}

// Writes the title of a curve: "Scree, NVIDIA H200, OpenCL".
static void curve_title(const Table* table, const Row* row, int curve, char text[192])
{
	char device[144] = "";
	if (row)
		table_device(table, row, device, sizeof device);
	snprintf(text, 192, "%s, %s", plot_pipelines[curves[curve].pipeline], device);
}

// Writes two blocks of data for each curve: the sizes that were measured, and the sizes with estimates. The second
// block begins with the last measured size.
static void put_curves(FILE* to, const Table* table)
{
	fputs("$curves << EOD\n", to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
		for (int c = 0; c < CURVES; ++c)
			for (int run = 1; run >= 0; --run)
			{
				const Row *row = NULL, *last = NULL;
				fputs("NaN NaN\n", to);
				for (; (row = curve_next(table, row, s, c)); last = row)
				{
					if (!run && !row->run && last && last->run)
						fprintf(to, "%g %g\n", last->bodies, last->ms);
					if (row->run == (run != 0))
						fprintf(to, "%g %g\n", row->bodies, row->ms);
				}
				fputs("\n\n", to);
			}
	fputs("EOD\n", to);
}

// Marks crossovers by triangles. A crossover is the number of bodies from which OpenCL is faster than the CPU. In left
// plots this number is beside the triangle. In right plots triangles are close together, so the numbers are in the
// empty corner.
static void put_crossovers(FILE* to, const Table* table, int scene, double most)
{
	int lines = 0;
	for (int c = 0; c < CURVES; ++c)
	{
		double ms, bodies = table_crossover(table, scene, curves[c].pipeline, curves[c].place, &ms);
		if (bodies <= 0 || bodies >= most)
			continue;
		char text[PLOT_TEXT];
		plot_number(bodies, text);
		bool above = curves[c].place == ON_ONE_THREAD, corner = most > AXIS;
		fprintf(to, "set label '%s' at %g, %g %s point pt 9 ps 1.1 lc '#000000' front offset %g, %g\n",
		        corner ? "" : text, bodies, ms, above ? "right" : "left", above ? -0.6 : 0.6, above ? 0.7 : -0.7);
		if (!corner)
			continue;
		if (lines == 0)
			fputs("set label 'OpenCL is faster from' at graph 0.03, 0.93 boxed\n", to);
		const Row* first = curve_next(table, NULL, scene, c);
		fprintf(to, "set label '%s: %s, %s' at graph 0.03, %g boxed\n", text, plot_pipelines[curves[c].pipeline],
		        first->device, 0.93 - 0.08 * ++lines);
	}
}

static const Row* last_of(const Table* table, int scene, int curve)
{
	const Row *last = NULL, *row = NULL;
	while ((row = curve_next(table, row, scene, curve)))
		last = row;
	return last;
}

// Labels the end of each curve whose last row is an estimate, but not if its value is within a factor of 3 of the
// previous label.
static void put_estimates(FILE* to, const Table* table, int scene)
{
	double top = 0, before = 0;
	for (int c = 0; c < CURVES; ++c)
	{
		const Row* last = last_of(table, scene, c);
		if (last)
			top = fmax(top, last->ms);
		if (!last || last->run || (before > 0 && before < 3 * last->ms && last->ms < 3 * before))
			continue;
		char text[PLOT_TEXT];
		plot_duration(last->ms, text);
		fprintf(to, "set label 'at most %s' at %g, %g right front offset -2.6, 0.3\n", text, last->bodies, last->ms);
		before = last->ms;
	}
	fprintf(to, "set yrange [*:%g]\n", 100 * top);
}

// Writes the legend of all plots: an empty plot below the others, which shows the names of curves and marks.
static void put_legend(FILE* to, const Table* table)
{
	fputs("set origin 0, 0\nset size 1, 0.13\nset lmargin at screen 0.02\nset rmargin at screen 0.98\n"
	      "set bmargin at screen 0.005\nset tmargin at screen 0.125\nunset title\nunset border\nunset tics\n"
	      "unset xlabel\nunset ylabel\nunset grid\nunset logscale\nset xrange [0:1]\nset yrange [0:1]\n"
	      "set key center center vertical Left reverse noenhanced samplen 3 width 1 maxrows 4\nplot NaN notitle",
	      to);
	for (int c = 0; c < CURVES; ++c)
	{
		const Row* row = NULL;
		for (int s = 0; s < FIGURE_SCENES && !row; ++s)
			row = curve_next(table, NULL, s, c);
		if (!row)
			continue;
		char title[192];
		curve_title(table, row, c, title);
		fprintf(to, ", NaN with linespoints lc rgb color[%d] pt shape[%d] title '%s'", c + 1, c + 1, title);
	}
	fputs(", NaN with lines dt 2 lc rgb '#555555' title 'not run: upper estimate'"
	      ", NaN with points pt 9 ps 1.1 lc rgb '#000000' title 'OpenCL becomes faster than the CPU'\n",
	      to);
}

void plot_curves(FILE* to, const Table* table)
{
	put_curves(to, table);
	fputs("set grid\nset xlabel 'bodies' offset 0, 0.6\nset style textbox opaque noborder margins 0.3, 0.3\n"
	      "set style data linespoints\nset pointsize 0.75\n" CURVE_COLORS "array shape[5] = [6, 4, 8, 7, 5]\n"
	      "set multiplot layout 2, 2 margins 0.125, 0.95, 0.215, 0.955 spacing 0.115, 0.135\n",
	      to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
	{
		if (!table_has_scene(table, s))
			continue;
		fprintf(to, "run(k) = %d + 2 * (k - 1)\nset title '%s' offset 0, -0.4\n", 2 * s * CURVES, plot_scenes[s]);
		fputs("unset logscale\nset logscale y\nset format x '%g'\nset xtics autofreq\nset mytics 10\n" TIMES
		      "set ylabel 'time of a step' offset 0.8, 0\n",
		      to);
		fprintf(to, "set xrange [0:%d]\nset yrange [*:*]\nunset key\n", AXIS);
		put_crossovers(to, table, s, AXIS);
		fputs("plot for [k=1:5] $curves index run(k) using 1:2 lc rgb color[k] pt shape[k]\nunset label\n", to);

		fprintf(to, "set title '%s, up to a million'\nunset ylabel\n", plot_scenes[s]);
		fputs("set logscale xy\nset xtics ('100' 100, '1,000' 1e3, '10,000' 1e4, '100,000' 1e5, '1,000,000' 1e6)\n"
		      "set xrange [20:1.5e6]\n" LONG_TIMES,
		      to);
		put_crossovers(to, table, s, INFINITY);
		put_estimates(to, table, s);
		fputs("plot for [k=1:5] $curves index run(k) using 1:2 lc rgb color[k] pt shape[k], "
		      "for [k=1:5] $curves index run(k) + 1 using 1:2 with lines dt 2 lc rgb color[k]\nunset label\n",
		      to);
	}
	put_legend(to, table);
	fputs("unset multiplot\n", to);
}
