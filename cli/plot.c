// SPDX-License-Identifier: MIT
// plot.c -- the figures of scree bench, drawn by gnuplot (Debian: gnuplot-nox) from nothing but their CSV.
#include "figure.h"
#include "options.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE  2048 // bytes of the longest line
#define CELLS 64   // of the longest row
#define ROWS  1024 // of a figure

typedef struct
{
	int scene, pipeline, far; // far: on OpenCL
	double bodies, ms;        // of a step
	bool run;                 // else ms is what a step would take
	double stages[FIGURE_STAGE_COUNT];
	char device[64];
} Row;

typedef struct
{
	Row rows[ROWS];
	int count;
} Table;

static int place_of(const char* name, const char* const* names, int count)
{
	int k = 0;
	while (k < count && strcmp(name, names[k]) != 0)
		++k;
	return k < count ? k : -1;
}

// Cuts a line at its commas and returns how many cells there are.
static int cut(char* line, const char* cells[CELLS])
{
	int count = 0;
	line[strcspn(line, "\r\n")] = 0;
	for (bool more = true; more && count < CELLS; ++count)
	{
		cells[count] = line;
		line += strcspn(line, ",");
		more = *line != 0;
		*line++ = 0;
	}
	return count;
}

static bool read_row(const char* const* heads, const char* const* cells, int count, Row* row)
{
	const char* threads = "";
	*row = (Row){.scene = -1, .pipeline = -1};
	for (int k = 0; k < count; ++k)
	{
		double number = atof(cells[k]);
		int stage = strncmp(heads[k], "ms_", 3) == 0 ? place_of(heads[k] + 3, figure_stages, FIGURE_STAGE_COUNT) : -1;
		if (strcmp(heads[k], "scene") == 0)
			row->scene = place_of(cells[k], figure_scenes, FIGURE_SCENES);
		else if (strcmp(heads[k], "pipeline") == 0)
			row->pipeline = place_of(cells[k], figure_pipelines, FIGURE_PIPELINES);
		else if (strcmp(heads[k], "device") == 0)
			snprintf(row->device, sizeof row->device, "%s", cells[k]);
		else if (strcmp(heads[k], "threads") == 0)
			threads = cells[k];
		else if (strcmp(heads[k], "bodies") == 0)
			row->bodies = number;
		else if (strcmp(heads[k], "steps") == 0)
			row->run = number > 0;
		else if (strcmp(heads[k], "ms_step") == 0)
			row->ms = number;
		else if (stage >= 0)
			row->stages[stage] = number;
	}
	row->far = strncmp(row->device, "opencl:", 7) == 0;
	if (row->far)
		memmove(row->device, row->device + 7, strlen(row->device + 7) + 1);
	else if (*threads)
		snprintf(row->device, sizeof row->device, "CPU, %s thread%s", threads, strcmp(threads, "1") == 0 ? "" : "s");
	return row->scene >= 0 && row->pipeline >= 0 && row->bodies > 0 && row->ms > 0;
}

static int read_table(const char* csv, Table* table)
{
	char head_line[LINE], line[LINE];
	const char *heads[CELLS], *cells[CELLS];
	FILE* file = fopen(csv, "r");
	if (!file)
	{
		fprintf(stderr, "scree bench: cannot read %s: %s\n", csv, strerror(errno));
		return EXIT_BAD;
	}
	int columns = fgets(head_line, sizeof head_line, file) ? cut(head_line, heads) : 0, code = EXIT_GOOD;
	for (int number = 2; code == EXIT_GOOD && fgets(line, sizeof line, file); ++number)
	{
		if (table->count < ROWS && cut(line, cells) == columns &&
		    read_row(heads, cells, columns, &table->rows[table->count]))
			++table->count;
		else
			code = EXIT_BAD;
		if (code != EXIT_GOOD)
			fprintf(stderr, "scree bench: %s: line %d is not a row of a figure\n", csv, number);
	}
	fclose(file);
	if (code == EXIT_GOOD && table->count == 0)
	{
		fprintf(stderr, "scree bench: %s has no rows\n", csv);
		code = EXIT_BAD;
	}
	return code;
}

// The next row of a curve after one, null at the end.
static const Row* next(const Table* table, const Row* after, int scene, int pipeline, int far)
{
	for (const Row* r = after ? after + 1 : table->rows; r < table->rows + table->count; ++r)
		if (r->scene == scene && r->pipeline == pipeline && r->far == far)
			return r;
	return NULL;
}

// Where OpenCL becomes faster than the CPU for good, between two sizes: both costs are taken for powers of the number of
// bodies. Returns 0 where it never does, or does from the smallest size on.
static double crossover(const Table* table, int scene, int pipeline, double* ms)
{
	double bodies = 0, before = 0, last_bodies = 0, last_ms = 0;
	const Row *near = NULL, *far = next(table, NULL, scene, pipeline, 1);
	while ((near = next(table, near, scene, pipeline, 0)) && far && near->run && far->run)
	{
		double now = log(near->ms / far->ms);
		if (now <= 0)
			bodies = 0;
		else if (last_bodies > 0 && before <= 0)
		{
			double share = before / (before - now);
			bodies = exp(log(last_bodies) + share * log(near->bodies / last_bodies));
			*ms = exp(log(last_ms) + share * log(near->ms / last_ms));
		}
		before = now;
		last_bodies = near->bodies;
		last_ms = near->ms;
		far = next(table, far, scene, pipeline, 1);
	}
	return bodies;
}

static void print_crossovers(const Table* table)
{
	for (int s = 0; s < FIGURE_SCENES; ++s)
		for (int p = 0; p < FIGURE_PIPELINES; ++p)
		{
			double ms, bodies = crossover(table, s, p, &ms);
			if (bodies > 0)
				printf("%s, %s: OpenCL is faster than the CPU from %.0f bodies on\n", figure_scenes[s],
				       figure_pipelines[p], bodies);
			else if (next(table, NULL, s, p, 0) && next(table, NULL, s, p, 1))
				printf("%s, %s: no crossover\n", figure_scenes[s], figure_pipelines[p]);
		}
}

static void duration(double ms, char text[32])
{
	static const struct
	{
		double ms;
		const char* name;
	} units[] = {{86400e3, "days"}, {3600e3, "h"}, {60e3, "min"}, {1e3, "s"}, {1, "ms"}};
	int k = 0;
	while (k < 4 && ms < 2 * units[k].ms)
		++k;
	snprintf(text, 32, "%.0f %s", ms / units[k].ms, units[k].name);
}

static const char* const titles[] = {"the paper's pipeline", "Scree"};

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
					if ((row = next(table, NULL, s, p, far)))
						device = row->device;
					fprintf(to, "\"%s, %s\"\nNaN NaN\n", titles[p], device);
					for (row = NULL; (row = next(table, row, s, p, far)); last = row)
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

static void put_marks(FILE* to, const Table* table, int scene)
{
	for (int p = 0; p < FIGURE_PIPELINES; ++p)
	{
		double ms, bodies = crossover(table, scene, p, &ms);
		if (bodies > 0)
			fprintf(to, "set label '%.0f' at %g, %g point pt 8 ps 2 lc '#000000' front offset 0.8, %g\n", bodies,
			        bodies, ms, p ? -1.0 : 1.0);
		// the largest size is what the last estimate is of, and the one on OpenCL says enough
		const Row *last = NULL, *row = NULL;
		for (int far = 0; far < 2; ++far)
			while ((row = next(table, row, scene, p, far)))
				last = row;
		char text[32];
		if (!last || last->run)
			continue;
		duration(last->ms, text);
		fprintf(to, "set label 'not run: a step would take %s' at %g, %g right front offset -1, 0\n", text,
		        last->bodies, last->ms);
	}
}

// Left as the paper has it, right to the end; a row a scene.
static void put_figure5(FILE* to, const Table* table)
{
	static const char* const scenes[] = {"boxes that stand apart", "pyramids of ten boxes"};
	put_curves(to, table);
	fputs("set grid\nset xlabel 'bodies'\nset ylabel 'ms a step'\nset style data linespoints\n"
	      "array color[4] = ['#d95f02', '#e6ab02', '#7570b3', '#1b9e77']\narray shape[4] = [6, 4, 7, 5]\n"
	      "set multiplot layout 2, 2\n",
	      to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
	{
		fprintf(to,
		        "unset logscale\nset format x '%%g'\nset xrange [0:560]\nset yrange [0:*]\nset key left top Left "
		        "reverse samplen 2\nset title '%s'\n"
		        "plot for [k=0:3] $curves index %d + 2 * k using 1:2 lc rgb color[k + 1] pt shape[k + 1] ps 0.5 title "
		        "columnheader(1)\n",
		        scenes[s], 8 * s);
		fputs("set logscale xy\nset xrange [20:1.5e6]\nset yrange [*:*]\nset format x '10^{%L}'\nunset key\n", to);
		fprintf(to, "set title '%s, to a million; triangles: crossovers, dashed: not run'\n", scenes[s]);
		put_marks(to, table, s);
		fprintf(to,
		        "plot for [k=0:3] $curves index %d + 2 * k using 1:2 lc rgb color[k + 1] pt shape[k + 1] ps 0.5, "
		        "for [k=0:3] $curves index %d + 2 * k using 1:2 with lines dt 2 lc rgb color[k + 1]\nunset label\n",
		        8 * s, 8 * s + 1);
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
	const Row* rows[ROWS];
	double places[ROWS];
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
		if (rows[k]->run && rows[k]->ms < 10)
			snprintf(text, sizeof text, "%.2g ms", rows[k]->ms);
		if (rows[k]->run)
			fprintf(to, "set label '%s' at %g, 101 rotate left\n", text, places[k]);
		else
			fprintf(to, "set label 'not run: a step would take %s' at %g, 3 rotate left\n", text, places[k]);
		if (k == 0 || rows[k]->bodies != rows[k - 1]->bodies)
			first = places[k];
		if (k + 1 == count || rows[k]->bodies != rows[k + 1]->bodies)
			fprintf(to, "set label '%.0f bodies' at %g, 128 center\n", rows[k]->bodies, (first + places[k]) / 2);
	}
	fprintf(to, "set xrange [0:%g]\n", x + 1);
}

static void put_figure6(FILE* to, const Table* table)
{
	fputs("set style fill solid 0.9 border -1\nset yrange [0:135]\nset ytics 0, 25, 100\nset grid y\n"
	      "set ylabel 'share of the stages, %'\nset xtics rotate by -60 noenhanced scale 0\n"
	      "array color[11] = ['#bdbdbd', '#737373', '#a6761d', '#66a61e', '#d95f02', '#e7298a', '#e6ab02', '#7570b3', "
	      "'#80b1d3', '#1b9e77', '#fccde5']\nset multiplot layout 1, 2\n",
	      to);
	for (int s = 0; s < FIGURE_SCENES; ++s)
	{
		put_scene(to, table, s);
		fprintf(to, "set title '%s'\n",
		        s ? "pyramids of ten boxes" : "boxes that stand apart; above the bars: a whole step");
		fputs(s ? "set key outside right center Left reverse invert noenhanced samplen 1\n" : "unset key\n", to);
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
	    {"png", "pngcairo size 1800,1350 fontscale 1.4 linewidth 1.6"},
	};
	char paths[2][1024];
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
	int code = read_table(csv, table);
	if (code == EXIT_GOOD && number == 5)
		print_crossovers(table);
	if (code == EXIT_GOOD && system("command -v gnuplot >/dev/null 2>&1") != 0)
		fprintf(stderr, "scree bench: %s is not drawn, because there is no gnuplot (Debian: gnuplot-nox)\n", csv);
	else if (code == EXIT_GOOD)
		code = draw(table, csv, number);
	free(table);
	return code;
}
