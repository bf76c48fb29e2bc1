// SPDX-License-Identifier: MIT
// known_hashes.c -- reads the hashes of an earlier bench, with which the hashes of a new bench must agree.
#include "known_hashes.h"
#include "csv.h"
#include "tools/common/open_input.h"
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum
{
	COLUMN_SCENE,
	COLUMN_SETTINGS,
	COLUMN_STEPS,
	COLUMN_HASH,
	COLUMNS
};
static const char* const names[COLUMNS] = {"scene", "settings", "steps", "hash"};

static bool find_columns(char* line, int columns[COLUMNS])
{
	char* cells[CSV_CELLS];
	int found = 0;
	csv_cut(line, cells);
	for (int column = 0; column < COLUMNS; ++column)
	{
		int k = 0;
		while (k < CSV_CELLS && strcmp(cells[k], names[column]) != 0)
			++k;
		columns[column] = k;
		found += k < CSV_CELLS;
	}
	return found == COLUMNS;
}

static bool read_row(char* line, const int columns[COLUMNS], KnownRow* row)
{
	char *cells[CSV_CELLS], extra;
	csv_cut(line, cells);
	const char *scene = cells[columns[COLUMN_SCENE]], *settings = cells[columns[COLUMN_SETTINGS]];
	if (strlen(scene) >= sizeof row->scene || strlen(settings) >= sizeof row->settings)
		return false;
	strcpy(row->scene, scene);
	strcpy(row->settings, settings);
	return sscanf(cells[columns[COLUMN_STEPS]], "%d%c", &row->steps, &extra) == 1 &&
	       sscanf(cells[columns[COLUMN_HASH]], "%16" SCNx64 "%c", &row->hash, &extra) == 1;
}

static int read_rows(FILE* file, const char* path, Known* known)
{
	char line[CSV_LINE];
	int columns[COLUMNS];
	if (!fgets(line, sizeof line, file) || !find_columns(line, columns))
	{
		fprintf(stderr, "%s bench: %s: its first line must name the columns scene, settings, steps and hash\n",
		        program_name, path);
		return EXIT_BAD;
	}
	for (int number = 2; fgets(line, sizeof line, file); ++number)
	{
		KnownRow* rows = realloc(known->rows, (size_t)(known->count + 1) * sizeof *rows);
		if (!rows)
		{
			fprintf(stderr, "%s bench: out of memory for the rows of %s\n", program_name, path);
			return EXIT_FAILED;
		}
		known->rows = rows;
		if (!read_row(line, columns, &rows[known->count]))
		{
			fprintf(stderr, "%s bench: %s: line %d is not a row of its columns\n", program_name, path, number);
			return EXIT_BAD;
		}
		++known->count;
	}
	return EXIT_GOOD;
}

int known_open(const char* path, Known* known)
{
	*known = (Known){0};
	if (!path)
		return EXIT_GOOD;
	FILE* file = open_input(path);
	if (!file)
	{
		fprintf(stderr, "%s bench: cannot read %s: %s\n", program_name, path, strerror(errno));
		return EXIT_BAD;
	}
	int code = read_rows(file, path, known);
	fclose(file);
	return code;
}

void known_close(Known* known)
{
	free(known->rows);
	*known = (Known){0};
}

bool known_agrees(const Known* known, const char* path, const char* scene, const char* settings, int steps,
                  uint64_t hash)
{
	for (int k = 0; k < known->count; ++k)
	{
		const KnownRow* row = &known->rows[k];
		if (row->steps != steps || strcmp(row->scene, scene) != 0 || strcmp(row->settings, settings) != 0)
			continue;
		if (row->hash != hash)
			fprintf(stderr, "%s bench: %s is invalid: its hash is %016" PRIx64 ", but %s has %016" PRIx64 "\n",
			        program_name, scene, hash, path, row->hash);
		return row->hash == hash;
	}
	return true;
}
