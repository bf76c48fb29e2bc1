// SPDX-License-Identifier: MIT
// plot_bars.c -- writes figure 6 as commands for gnuplot: share of each stage in a step.
#include "tools/paper/plot_bars.h"
#include "tools/common/spaced.h"
#include "tools/paper/plot_text.h"

// Colors of stages. Light and dark colors take turns in a bar, so that stages can also be distinguished in gray.
#define STAGE_COLORS                                                                                              \
	"array color[11] = ['#d9d9d9', '#636363', '#e3c59a', '#4d8a1c', '#f0a35e', '#8c1d5a', '#f2c84b', '#5a4fa0', " \
	"'#a9d3f0', '#1b7f5f', '#fccde5']\n"

// Writes the data of a bar for a row: the position x of the bar, 0 for its lower edge, and the upper edge of each
// stage, as a percentage of the time of all stages.
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
	// rows of a scene are in ascending order of size
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
		char text[PLOT_TEXT];
		plot_duration(rows[k]->ms, text);
		fprintf(to, "set xtics add ('%s, %s' %g)\n", plot_pipelines[rows[k]->pipeline],
		        rows[k]->place == ON_OPENCL ? "OpenCL" : rows[k]->device, places[k]);
		if (rows[k]->run)
			fprintf(to, "set label '%s' at %g, 102 rotate left\n", text, places[k]);
		else
			fprintf(to, "set label 'at most %s' at %g, 3 rotate left\n", text, places[k]);
		if (k == 0 || rows[k]->bodies != rows[k - 1]->bodies)
			first = places[k];
		if (k + 1 == count || rows[k]->bodies != rows[k + 1]->bodies)
		{
			plot_number(rows[k]->bodies, text);
			fprintf(to, "set label '%s bodies' at %g, 175 center\n", text, (first + places[k]) / 2);
		}
	}
	fprintf(to, "set xrange [0:%g]\n", x + 1);
}

// Writes a plot command for all stages: the bars of a scene or, if `legend` is set, only their legend in an empty plot.
static void put_stages(FILE* to, bool legend)
{
	fputs("plot NaN notitle", to);
	for (int k = 0; k < FIGURE_STAGE_COUNT; ++k)
	{
		char text[PLOT_TEXT];
		spaced(figure_stages[k], text, sizeof text);
		if (legend)
			fprintf(to, ", NaN with boxes lc rgb color[%d] title '%s'", k + 1, text);
		else
			fprintf(to, ", $bars using 1:%d:($1-0.45):($1+0.45):%d:%d with boxxyerror lc rgb color[%d] notitle", k + 3,
			        k + 2, k + 3, k + 1);
	}
	fputs("\n", to);
}

void plot_bars(FILE* to, const Table* table)
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
		if (!table_has_scene(table, s))
			continue;
		put_scene(to, table, s);
		fprintf(to, "set title '%s'\n", plot_scenes[s]);
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
