// SPDX-License-Identifier: MIT
// table.c -- reads the rows of a figure's CSV, and computes the crossovers of its curves.
#include "tools/paper/table.h"
#include "cli/common/csv.h"
#include "cli/common/options.h"
#include <ctype.h>
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

// Removes every occurrence of a part from a text.
static void remove_all(char* text, const char* part)
{
	for (char* at = strstr(text, part); at; at = strstr(at, part))
		memmove(at, at + strlen(part), strlen(at + strlen(part)) + 1);
}

// Writes the name of a device for readers: "opencl:NVIDIA H200" becomes "NVIDIA H200". PoCL puts the architecture
// before the processor: "opencl:cpu-skylake-avx512-Intel(R) Xeon(R) Processor" becomes "PoCL, Intel Xeon Processor".
static void show_device(const char* device, char* text, size_t size)
{
	static const char* const pocl[] = {"cpu-", "pthread-"};
	const char *name = device + strlen("opencl:"), *kind = "";
	for (int k = 0; k < 2; ++k)
		if (strncmp(name, pocl[k], strlen(pocl[k])) == 0)
		{
			kind = "PoCL, ";
			while (*name && !isupper((unsigned char)*name))
				++name;
		}
	snprintf(text, size, "%s%s", kind, name);
	remove_all(text, "(R)");
	remove_all(text, "(TM)");
	for (; *text; ++text)
		*text = *text == '_' || *text == '"' ? ' ' : *text;
}

static bool read_row(char* const* heads, char* const* cells, int count, Row* row)
{
	const char *threads = "", *device = "";
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
			device = cells[k];
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
	int count_of_threads = atoi(threads);
	row->place = strncmp(device, "opencl:", 7) == 0 ? ON_OPENCL : count_of_threads > 1 ? ON_THREADS : ON_ONE_THREAD;
	if (row->place == ON_OPENCL)
		show_device(device, row->device, sizeof row->device);
	else if (row->place == ON_THREADS)
		snprintf(row->device, sizeof row->device, "%d threads", count_of_threads);
	else
		snprintf(row->device, sizeof row->device, "1 thread");
	return row->scene >= 0 && row->pipeline >= 0 && row->bodies > 0 && row->ms > 0;
}

// Reads the name of the processor from machine.txt, which bench/gpu.sh writes. Its line is "processor: Intel(R) Xeon(R)
// Processor, 16 cores".
static void read_processor(const char* csv, char* text, size_t size)
{
	static const char head[] = "processor: ";
	static const char* const noise[] = {"(R)", "(TM)", " Processor", " CPU"};
	char path[1024], line[256];
	const char* slash = strrchr(csv, '/');
	snprintf(path, sizeof path, "%.*smachine.txt", slash ? (int)(slash - csv) + 1 : 0, csv);
	snprintf(text, size, "CPU");
	FILE* file = fopen(path, "r");
	while (file && fgets(line, sizeof line, file))
	{
		if (strncmp(line, head, sizeof head - 1) != 0)
			continue;
		for (int k = 0; k < 4; ++k)
			remove_all(line, noise[k]);
		snprintf(text, size, "%.*s", (int)strcspn(line + sizeof head - 1, ",(@\n"), line + sizeof head - 1);
	}
	if (file)
		fclose(file);
}

void table_device(const Table* table, const Row* row, char* text, size_t size)
{
	if (row->place == ON_OPENCL)
		snprintf(text, size, "%s, OpenCL", row->device);
	else
		snprintf(text, size, "%s, %s", table->processor, row->device);
}

int table_read(const char* csv, Table* table)
{
	char head_line[CSV_LINE], line[CSV_LINE];
	char *heads[CSV_CELLS], *cells[CSV_CELLS];
	FILE* file = fopen(csv, "r");
	if (!file)
	{
		fprintf(stderr, "scree_paper: cannot read %s: %s\n", csv, strerror(errno));
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
			fprintf(stderr, "scree_paper: %s: line %d is not a row of a figure\n", csv, number);
	}
	fclose(file);
	read_processor(csv, table->processor, sizeof table->processor);
	if (code == EXIT_GOOD && table->count == 0)
	{
		fprintf(stderr, "scree_paper: %s has no rows\n", csv);
		code = EXIT_BAD;
	}
	return code;
}

const Row* table_next(const Table* table, const Row* after, int scene, int pipeline, FigurePlace place)
{
	for (const Row* r = after ? after + 1 : table->rows; r < table->rows + table->count; ++r)
		if (r->scene == scene && r->pipeline == pipeline && r->place == place)
			return r;
	return NULL;
}

bool table_has_scene(const Table* table, int scene)
{
	bool found = false;
	for (int k = 0; k < table->count; ++k)
		found = found || table->rows[k].scene == scene;
	return found;
}

// Between two sizes, both times are interpolated as powers of the number of bodies.
double table_crossover(const Table* table, int scene, int pipeline, FigurePlace place, double* ms)
{
	double bodies = 0, before = 0, last_bodies = 0, last_ms = 0;
	const Row *near = NULL, *far = table_next(table, NULL, scene, pipeline, ON_OPENCL);
	while ((near = table_next(table, near, scene, pipeline, place)) && far && near->run && far->run)
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
		far = table_next(table, far, scene, pipeline, ON_OPENCL);
	}
	return bodies;
}

void table_print_crossovers(const Table* table)
{
	for (int s = 0; s < FIGURE_SCENES; ++s)
		for (int p = 0; p < FIGURE_PIPELINES; ++p)
			for (int place = ON_ONE_THREAD; place < ON_OPENCL; ++place)
			{
				const Row* near = table_next(table, NULL, s, p, (FigurePlace)place);
				double ms, bodies = table_crossover(table, s, p, (FigurePlace)place, &ms);
				if (bodies > 0)
					printf("%s, %s: OpenCL is faster than %s of the CPU from %.0f bodies on\n", figure_scenes[s],
					       figure_pipelines[p], near->device, bodies);
				else if (near && table_next(table, NULL, s, p, ON_OPENCL))
					printf("%s, %s: no crossover of OpenCL and %s of the CPU\n", figure_scenes[s], figure_pipelines[p],
					       near->device);
			}
}
