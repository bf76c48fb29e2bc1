// SPDX-License-Identifier: MIT
// table.c -- the rows of a figure's CSV, and where its curves cross.
#include "table.h"
#include "csv.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int place_of(const char* name, const char* const* names, int count)
{
	int k = 0;
	while (k < count && strcmp(name, names[k]) != 0)
		++k;
	return k < count ? k : -1;
}

static bool read_row(char* const* heads, char* const* cells, int count, Row* row)
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

int table_read(const char* csv, Table* table)
{
	char head_line[CSV_LINE], line[CSV_LINE];
	char *heads[CSV_CELLS], *cells[CSV_CELLS];
	FILE* file = fopen(csv, "r");
	if (!file)
	{
		fprintf(stderr, "scree bench: cannot read %s: %s\n", csv, strerror(errno));
		return EXIT_BAD;
	}
	int columns = fgets(head_line, sizeof head_line, file) ? csv_cut(head_line, heads) : 0, code = EXIT_GOOD;
	for (int number = 2; code == EXIT_GOOD && fgets(line, sizeof line, file); ++number)
	{
		if (table->count < MAX_ROWS && csv_cut(line, cells) == columns &&
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

const Row* table_next(const Table* table, const Row* after, int scene, int pipeline, int far)
{
	for (const Row* r = after ? after + 1 : table->rows; r < table->rows + table->count; ++r)
		if (r->scene == scene && r->pipeline == pipeline && r->far == far)
			return r;
	return NULL;
}

// Between two sizes both costs are taken for powers of the number of bodies.
double table_crossover(const Table* table, int scene, int pipeline, double* ms)
{
	double bodies = 0, before = 0, last_bodies = 0, last_ms = 0;
	const Row *near = NULL, *far = table_next(table, NULL, scene, pipeline, 1);
	while ((near = table_next(table, near, scene, pipeline, 0)) && far && near->run && far->run)
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
		far = table_next(table, far, scene, pipeline, 1);
	}
	return bodies;
}

void table_print_crossovers(const Table* table)
{
	for (int s = 0; s < FIGURE_SCENES; ++s)
		for (int p = 0; p < FIGURE_PIPELINES; ++p)
		{
			double ms, bodies = table_crossover(table, s, p, &ms);
			if (bodies > 0)
				printf("%s, %s: OpenCL is faster than the CPU from %.0f bodies on\n", figure_scenes[s],
				       figure_pipelines[p], bodies);
			else if (table_next(table, NULL, s, p, 0) && table_next(table, NULL, s, p, 1))
				printf("%s, %s: no crossover\n", figure_scenes[s], figure_pipelines[p]);
		}
}
