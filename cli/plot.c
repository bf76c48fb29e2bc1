// SPDX-License-Identifier: MIT
// plot.c -- draws the figures of scree bench from their CSV, with gnuplot (Debian: gnuplot-nox).
#include "plot.h"
#include "table.h"
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void duration(double ms, char text[32])
{
	static const struct
	{
		double ms;
		const char* name;
	} units[] = {{86400e3, "days"}, {3600e3, "h"}, {60e3, "min"}, {1e3, "s"}, {1, "ms"}};
	int k = 0;
	while (k < 4 && ms < units[k].ms)
		++k;
	double number = ms / units[k].ms;
	snprintf(text, 32, number < 10 ? "%.2g %s" : "%.0f %s", number, units[k].name);
}

// Writes 10000 as "10,000".
static void number_text(double number, char text[32])
{
	char digits[32];
	int length = snprintf(digits, sizeof digits, "%.0f", number), k = 0;
	for (const char* digit = digits; *digit && k < 30; ++digit)
	{
		text[k++] = *digit;
		if (--length > 0 && length % 3 == 0)
			text[k++] = ',';
	}
	text[k] = 0;
}

#define AXIS 560 // bodies at the end of the left axis, a little more than the paper's 500

static const char* const titles[] = {"paper", "Scree"};
static const char* const scenes[] = {"boxes that drift", "pyramids of ten boxes"};

#define CURVES 5
static const struct
{
	int pipeline;
	FigurePlace place;
} curves[CURVES] = {{0, ON_ONE_THREAD}, {0, ON_OPENCL}, {1, ON_ONE_THREAD}, {1, ON_THREADS}, {1, ON_OPENCL}};

// colors that also the color-blind can tell apart: Okabe, Ito, Color Universal Design, 2008
#define CURVE_COLORS "array color[5] = ['#d55e00', '#e69f00', '#56b4e9', '#0072b2', '#009e73']\n"
// labels of the axes of time, whose numbers are ms
#define TIMES "set ytics ('1 µs' 1e-3, '10 µs' 1e-2, '0.1 ms' 0.1, '1 ms' 1, '10 ms' 10, '0.1 s' 100, '1 s' 1e3)\n"
#define LONG_TIMES \
	"set ytics ('10 µs' 1e-2, '1 ms' 1, '0.1 s' 100, '10 s' 1e4, '17 min' 1e6, '1.2 days' 1e8, '116 days' 1e10)\n"

// of stages: light and dark take turns in a bar, so that it can be read without colors
#define STAGE_COLORS                                                                                              \
	"array color[11] = ['#d9d9d9', '#636363', '#e3c59a', '#4d8a1c', '#f0a35e', '#8c1d5a', '#f2c84b', '#5a4fa0', " \
	"'#a9d3f0', '#1b7f5f', '#fccde5']\n"

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
	snprintf(text, 192, "%s, %s", titles[curves[curve].pipeline], device);
}

// Writes two blocks a curve: the sizes that were run, and the sizes that were not, which begin with the last size that was.
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

static bool has_scene(const Table* table, int scene)
{
	bool found = false;
	for (int k = 0; k < table->count; ++k)
		found = found || table->rows[k].scene == scene;
	return found;
}

// Marks with triangles where OpenCL becomes faster than the CPU. In the left plots the number of bodies is beside the triangle.
// In the right plots, where the triangles are close together, it is in the empty corner.
static void put_crossovers(FILE* to, const Table* table, int scene, double most)
{
	int lines = 0;
	for (int c = 0; c < CURVES; ++c)
	{
		double ms, bodies = table_crossover(table, scene, curves[c].pipeline, curves[c].place, &ms);
		if (bodies <= 0 || bodies >= most)
			continue;
		char text[32];
		number_text(bodies, text);
		bool above = curves[c].place == ON_ONE_THREAD, corner = most > AXIS;
		fprintf(to, "set label '%s' at %g, %g %s point pt 9 ps 1.1 lc '#000000' front offset %g, %g\n",
		        corner ? "" : text, bodies, ms, above ? "right" : "left", above ? -0.6 : 0.6, above ? 0.7 : -0.7);
		if (!corner)
			continue;
		if (lines == 0)
			fputs("set label 'OpenCL is faster from' at graph 0.03, 0.93 boxed\n", to);
		const Row* first = curve_next(table, NULL, scene, c);
		fprintf(to, "set label '%s: %s, %s' at graph 0.03, %g boxed\n", text, titles[curves[c].pipeline], first->device,
		        0.93 - 0.08 * ++lines);
	}
}

static const Row* last_of(const Table* table, int scene, int curve)
{
	const Row *last = NULL, *row = NULL;
	while ((row = curve_next(table, row, scene, curve)))
		last = row;
	return last;
}

// Labels the end of each curve that was not run with the estimate of a step; of curves that end close together only one.
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
		char text[32];
		duration(last->ms, text);
		fprintf(to, "set label 'at most %s' at %g, %g right front offset -2.6, 0.3\n", text, last->bodies, last->ms);
		before = last->ms;
	}
	fprintf(to, "set yrange [*:%g]\n", 100 * top);
}

// One legend for all plots: an empty plot below them, with the names of the curves and of the marks.
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
	fputs(", NaN with lines dt 2 lc rgb '#555555' title 'not run: at most so long'"
	      ", NaN with points pt 9 ps 1.1 lc rgb '#000000' title 'OpenCL becomes faster than the CPU'\n",
	      to);
}

// Two plots a scene: left up to the sizes of the paper, right up to a million bodies.
static void put_figure5(FILE* to, const Table* table)
{
	put_curves(to, table);
	fputs("set grid\nset xlabel 'bodies' offset 0, 0.6\nset style textbox opaque noborder margins 0.3, 0.3\n"
	      "set style data linespoints\nset pointsize 0.75\n" CURVE_COLORS "array shape[5] = [6, 4, 8, 7, 5]\n"
	      "set multiplot layout 2, 2 margins 0.125, 0.95, 0.215, 0.955 spacing 0.115, 0.135\n",
	      to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
	{
		if (!has_scene(table, s))
			continue;
		fprintf(to, "run(k) = %d + 2 * (k - 1)\nset title '%s' offset 0, -0.4\n", 2 * s * CURVES, scenes[s]);
		fputs("unset logscale\nset logscale y\nset format x '%g'\nset xtics autofreq\nset mytics 10\n" TIMES
		      "set ylabel 'time of a step' offset 0.8, 0\n",
		      to);
		fprintf(to, "set xrange [0:%d]\nset yrange [*:*]\nunset key\n", AXIS);
		put_crossovers(to, table, s, AXIS);
		fputs("plot for [k=1:5] $curves index run(k) using 1:2 lc rgb color[k] pt shape[k]\nunset label\n", to);

		fprintf(to, "set title '%s, up to a million'\nunset ylabel\n", scenes[s]);
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

// Writes the bar of a row: the edges of its stages in %.
static void put_bar(FILE* to, const Row* row, double x)
{
	double sum = 0, edge = 0;
	for (int k = 0; k < FIGURE_STAGE_COUNT; ++k)
		sum += row->stages[k];
	fprintf(to, "%g 0", x);
	for (int k = 0; k < FIGURE_STAGE_COUNT; ++k)
		fprintf(to, " %g", edge += sum > 0 ? 100 * row->stages[k] / sum : 0);
	fputs("\n", to);
}

static void put_scene(FILE* to, const Table* table, int scene)
{
	double x = 0, bodies = 0, first = 0;
	fprintf(to, "unset label\nset xtics ()\n$bars << EOD\n");
	// rows of a scene are in rising order of size
	const Row* rows[MAX_ROWS];
	double places[MAX_ROWS];
	int count = 0;
	for (const Row* r = table->rows; r < table->rows + table->count; ++r)
	{
		if (r->scene != scene)
			continue;
		x += bodies > 0 && r->bodies != bodies ? 2 : 1;
		bodies = r->bodies;
		rows[count] = r;
		places[count++] = x;
		if (r->run)
			put_bar(to, r, x);
	}
	fputs("EOD\n", to);
	for (int k = 0; k < count; ++k)
	{
		char text[32];
		duration(rows[k]->ms, text);
		fprintf(to, "set xtics add ('%s, %s' %g)\n", titles[rows[k]->pipeline],
		        rows[k]->place == ON_OPENCL ? "OpenCL" : rows[k]->device, places[k]);
		if (rows[k]->run)
			fprintf(to, "set label '%s' at %g, 102 rotate left\n", text, places[k]);
		else
			fprintf(to, "set label 'at most %s' at %g, 3 rotate left\n", text, places[k]);
		if (k == 0 || rows[k]->bodies != rows[k - 1]->bodies)
			first = places[k];
		if (k + 1 == count || rows[k]->bodies != rows[k + 1]->bodies)
		{
			number_text(rows[k]->bodies, text);
			fprintf(to, "set label '%s bodies' at %g, 175 center\n", text, (first + places[k]) / 2);
		}
	}
	fprintf(to, "set xrange [0:%g]\n", x + 1);
}

// Writes "to_device" as "to device".
static void stage_text(const char* name, char text[32])
{
	snprintf(text, 32, "%s", name);
	for (; *text; ++text)
		*text = *text == '_' ? ' ' : *text;
}

// The stages of a scene's bars, or their legend alone, in an empty plot beside the bars.
static void put_stages(FILE* to, bool legend)
{
	fputs("plot NaN notitle", to);
	for (int k = 0; k < FIGURE_STAGE_COUNT; ++k)
	{
		char text[32];
		stage_text(figure_stages[k], text);
		if (legend)
			fprintf(to, ", NaN with boxes lc rgb color[%d] title '%s'", k + 1, text);
		else
			fprintf(to, ", $bars using 1:%d:($1-0.45):($1+0.45):%d:%d with boxxyerror lc rgb color[%d] notitle", k + 3,
			        k + 2, k + 3, k + 1);
	}
	fputs("\n", to);
}

static void put_figure6(FILE* to, const Table* table)
{
	const char* device = "none";
	for (int k = 0; k < table->count; ++k)
		device = table->rows[k].place == ON_OPENCL ? table->rows[k].device : device;
	fprintf(to,
	        "set style fill solid 0.9 border -1\nset yrange [0:185]\nset ytics 0, 25, 100\nset grid y\nunset key\n"
	        "set ylabel 'share of the stages in a step, %%' offset 1, 0\n"
	        "set xtics rotate by 40 right noenhanced scale 0\n" STAGE_COLORS
	        "set multiplot layout 2, 1 margins 0.09, 0.8, 0.13, 0.9 spacing 0, 0.21 title \"above each bar: a whole "
	        "step; no "
	        "bar: not run; threads: %s; OpenCL: %s\" noenhanced\n",
	        table->processor, device);
	for (int s = 0; s < FIGURE_SCENES; ++s)
	{
		if (!has_scene(table, s))
			continue;
		put_scene(to, table, s);
		fprintf(to, "set title '%s'\n", scenes[s]);
		put_stages(to, false);
	}
	fputs(
	    "set lmargin at screen 0.8\nset rmargin at screen 0.995\nset bmargin at screen 0.1\nset tmargin at screen 0.9\n"
	    "unset title\nunset border\nunset tics\nunset ylabel\nunset grid\nunset label\nset xrange [0:1]\n"
	    "set key center center vertical maxrows 11 Left reverse invert noenhanced samplen 1 spacing 1.3\n",
	    to);
	put_stages(to, true);
	fputs("unset multiplot\n", to);
}

// The path of the CSV with another ending.
static void path_of(const char* csv, const char* ending, char* path, size_t size)
{
	size_t length = strlen(csv);
	if (length > 4 && strcmp(csv + length - 4, ".csv") == 0)
		length -= 4;
	snprintf(path, size, "%.*s.%s", (int)length, csv, ending);
}

static int draw(const Table* table, const char* csv, int number)
{
	static const char* const terminals[][2] = {
	    {"svg", "svg size 1100,1000 font 'Helvetica,19' linewidth 1.6 background 'white'"},
	    {"png", "pngcairo size 1650,1500 font 'Helvetica,19' fontscale 1.13 linewidth 2"},
	};
	char paths[2][1024];
	signal(SIGPIPE, SIG_IGN); // gnuplot may end before it has read all commands
	for (int k = 0; k < 2; ++k)
	{
		path_of(csv, terminals[k][0], paths[k], sizeof paths[k]);
		FILE* to = popen("gnuplot", "w");
		if (!to)
			return EXIT_FAILED;
		fprintf(to, "set terminal %s\nset output \"%s\"\n", terminals[k][1], paths[k]);
		if (number == 5)
			put_figure5(to, table);
		else
			put_figure6(to, table);
		if (pclose(to) != 0)
		{
			fprintf(stderr, "scree bench: gnuplot could not draw %s\n", csv);
			return EXIT_FAILED;
		}
	}
	printf("%s is drawn as %s and %s\n", csv, paths[0], paths[1]);
	return EXIT_GOOD;
}

int plot_figure(const char* csv, int number)
{
	Table* table = calloc(1, sizeof *table);
	if (!table)
	{
		fprintf(stderr, "scree bench: out of memory for the rows of %s\n", csv);
		return EXIT_FAILED;
	}
	int code = table_read(csv, table);
	if (code == EXIT_GOOD && number == 5)
		table_print_crossovers(table);
	if (code == EXIT_GOOD && system("command -v gnuplot >/dev/null 2>&1") != 0)
		fprintf(stderr, "scree bench: %s is not drawn, because there is no gnuplot (Debian: gnuplot-nox)\n", csv);
	else if (code == EXIT_GOOD)
		code = draw(table, csv, number);
	free(table);
	return code;
}
