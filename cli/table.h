// SPDX-License-Identifier: MIT
// table.h -- the rows of a figure's CSV, and where its curves cross.
#ifndef TABLE_H
#define TABLE_H
#include "figure.h"
#include <stdbool.h>

#define MAX_ROWS 1024

typedef struct
{
	int scene, pipeline;
	FigurePlace place;
	double bodies, ms; // of a step
	bool run;          // else ms is what a step would take
	double stages[FIGURE_STAGE_COUNT];
	char device[64]; // as it is shown: "1 thread", "NVIDIA H200"
} Row;

typedef struct
{
	Row rows[MAX_ROWS];
	int count;
} Table;

// Returns an exit code, after printing what is wrong.
int table_read(const char* csv, Table* table);

// The next row of a curve after one (null: the first), null at the end.
const Row* table_next(const Table* table, const Row* after, int scene, int pipeline, FigurePlace place);

// The bodies from which on OpenCL is faster than the CPU at that place for good, and the time of a step there. Returns
// 0 where it never is, or is from the smallest size on.
double table_crossover(const Table* table, int scene, int pipeline, FigurePlace place, double* ms);
void table_print_crossovers(const Table* table);

#endif
