// SPDX-License-Identifier: MIT
// plot.c -- the figures of scree bench, drawn by gnuplot (Debian: gnuplot-nox) from nothing but their CSV.
#include "options.h"
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

#define AXIS 560 // bodies at the end of the left axis, a little more than the paper's 500

static const char* const titles[] = {"paper", "Scree"};
static const char* const scenes[] = {"boxes that drift", "pyramids of ten boxes"};

// A block a curve, the part that was run and the part that was not, with the last point of the first to begin at.
static void put_curves(FILE* to, const Table* table)
{
	fputs("$curves << EOD\n", to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
		for (int p = 0; p < FIGURE_PIPELINES; ++p)
			for (int far = 0; far < 2; ++far)
				for (int run = 1; run >= 0; --run)
				{
					const Row *row = NULL, *last = NULL;
					const char* device = far ? "OpenCL" : "CPU";
					if ((row = table_next(table, NULL, s, p, far)))
						device = row->device;
					fprintf(to, "\"%s, %s\"\nNaN NaN\n", titles[p], device);
					for (row = NULL; (row = table_next(table, row, s, p, far)); last = row)
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

static void put_crossovers(FILE* to, const Table* table, int scene, double most)
{
	for (int p = 0; p < FIGURE_PIPELINES; ++p)
	{
		double ms, bodies = table_crossover(table, scene, p, &ms);
		if (bodies > 0 && bodies < most)
			fprintf(to, "set label '%.0f' at %g, %g point pt 8 ps 2 lc '#000000' front offset 0.8, %g\n", bodies,
			        bodies, ms, (p == 0) == (most == AXIS) ? -1.0 : 1.0); // where no curve is
	}
}

static const Row* last_of(const Table* table, int scene, int pipeline, int far)
{
	const Row *last = NULL, *row = NULL;
	while ((row = table_next(table, row, scene, pipeline, far)))
		last = row;
	return last;
}

// At the end of what was not run: how long a step would take. Where both devices would take about as long, once.
static void put_estimates(FILE* to, const Table* table, int scene)
{
	double top = 0;
	for (int p = 0; p < FIGURE_PIPELINES; ++p)
		for (int far = 0; far < 2; ++far)
		{
			const Row *last = last_of(table, scene, p, far), *other = last_of(table, scene, p, !far);
			if (last)
				top = fmax(top, last->ms);
			if (!last || last->run || (far && other && !other->run && other->ms < 3 * last->ms))
				continue;
			char text[32];
			duration(last->ms, text);
			fprintf(to, "set label 'up to %s' at %g, %g right front offset -1.5, 0\n", text, last->bodies, last->ms);
		}
	fprintf(to, "set yrange [*:%g]\n", 5 * top);
}

// Left as the paper has it, right to the end; a row a scene.
static void put_figure5(FILE* to, const Table* table)
{
	put_curves(to, table);
	fputs("set grid\nset xlabel 'bodies'\nset ylabel 'ms a step'\nset style data linespoints\nset pointsize 0.5\n"
	      "array color[4] = ['#d95f02', '#e6ab02', '#7570b3', '#1b9e77']\narray shape[4] = [6, 4, 7, 5]\n"
	      "set multiplot layout 2, 2 title 'triangle: OpenCL becomes faster than the CPU; dashed: not run, up to so "
	      "long a step'\n",
	      to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
	{
		if (!has_scene(table, s))
			continue;
		fprintf(to, "run(k) = %d + 2 * k\nset title '%s'\n", 4 * s * FIGURE_PIPELINES, scenes[s]);
		fprintf(to, "unset logscale\nset format '%%g'\nset xrange [0:%d]\nset yrange [0:*]\n", AXIS);
		put_crossovers(to, table, s, AXIS);
		fputs("set key left top Left reverse samplen 2\nplot for [k=0:3] $curves index run(k) using 1:2 lc rgb "
		      "color[k + 1] pt shape[k + 1] title columnheader(1)\nunset label\n",
		      to);

		fprintf(to, "set title '%s, to a million'\n", scenes[s]);
		fputs("set logscale xy\nset format '10^{%L}'\nset xrange [20:1.5e6]\nunset key\n", to);
		put_crossovers(to, table, s, INFINITY);
		put_estimates(to, table, s);
		fputs("plot for [k=0:3] $curves index run(k) using 1:2 lc rgb color[k + 1] pt shape[k + 1], "
		      "for [k=0:3] $curves index run(k) + 1 using 1:2 with lines dt 2 lc rgb color[k + 1]\nunset label\n",
		      to);
	}
	fputs("unset multiplot\n", to);
}

// A bar a row: the edges of its stages, %.
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
	// rows of a scene are in order of size
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
		fprintf(to, "set xtics add ('%s %s' %g)\n", rows[k]->pipeline ? "Scree" : "paper",
		        rows[k]->far ? "OpenCL" : "CPU", places[k]);
		if (rows[k]->run)
			fprintf(to, "set label '%s' at %g, 101 rotate left\n", text, places[k]);
		else
			fprintf(to, "set label 'not run: up to %s a step' at %g, 3 rotate left\n", text, places[k]);
		if (k == 0 || rows[k]->bodies != rows[k - 1]->bodies)
			first = places[k];
		if (k + 1 == count || rows[k]->bodies != rows[k + 1]->bodies)
			fprintf(to, "set label '%.0f bodies' at %g, 122 center\n", rows[k]->bodies, (first + places[k]) / 2);
	}
	fprintf(to, "set xrange [0:%g]\n", x + 1);
}

static void put_figure6(FILE* to, const Table* table)
{
	fputs("set style fill solid 0.9 border -1\nset yrange [0:126]\nset ytics 0, 25, 100\nset grid y\n"
	      "set ylabel 'share of the stages, %'\nset xtics rotate by -60 noenhanced scale 0\n"
	      "array color[11] = ['#bdbdbd', '#737373', '#a6761d', '#66a61e', '#d95f02', '#e7298a', '#e6ab02', '#7570b3', "
	      "'#80b1d3', '#1b9e77', '#fccde5']\nset multiplot layout 1, 2 title 'above each bar: a whole step'\n",
	      to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
	{
		if (!has_scene(table, s))
			continue;
		put_scene(to, table, s);
		fprintf(to, "set title '%s'\n", scenes[s]);
		fputs(s ? "set lmargin at screen 0.5\nset rmargin at screen 0.86\n"
		          "set key outside right center Left reverse invert noenhanced samplen 1\n"
		        : "set lmargin at screen 0.07\nset rmargin at screen 0.43\nunset key\n",
		      to);
		fputs("plot NaN notitle", to);
		for (int k = 0; k < FIGURE_STAGE_COUNT; ++k)
			fprintf(to, ", $bars using 1:%d:($1-0.45):($1+0.45):%d:%d with boxxyerror lc rgb color[%d] title '%s'",
			        k + 3, k + 2, k + 3, k + 1, figure_stages[k]);
		fputs("\n", to);
	}
	fputs("unset multiplot\n", to);
}

// The path of a CSV with another ending.
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
	    {"svg", "svg size 1200,900 background 'white'"},
	    {"png", "pngcairo size 1600,1200 fontscale 1.25 linewidth 1.4"},
	};
	char paths[2][1024];
	signal(SIGPIPE, SIG_IGN); // gnuplot may end before it has read all
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
