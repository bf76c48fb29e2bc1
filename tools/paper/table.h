// SPDX-License-Identifier: MIT
// table.h -- the rows of a figure's CSV, and the crossovers of its curves.
#ifndef TABLE_H
#define TABLE_H
#include "tools/paper/figure.h"
#include <stdbool.h>
#include <stddef.h>

#define MAX_ROWS 1024

typedef struct
{
	int scene, pipeline;
	FigurePlace place;
	double bodies, ms; // size of the world, time of a step
	bool run;          // else ms is an estimate
	double stages[FIGURE_STAGE_COUNT];
	char device[64]; // as in the figures: "1 thread", "NVIDIA H200"
} Row;

typedef struct
{
	Row rows[MAX_ROWS];
	int count;
	char processor[64]; // from machine.txt beside the CSV: "Intel Xeon"; "CPU" without it
} Table;

// Reads a CSV. Returns an exit code after printing a sentence.
int table_read(const char* csv, Table* table);

// The name of a row's device in full: "NVIDIA H200, OpenCL", "Intel Xeon, 16 threads".
void table_device(const Table* table, const Row* row, char* text, size_t size);

// The next row of a curve after another (null: the first row); null at the end.
const Row* table_next(const Table* table, const Row* after, int scene, int pipeline, FigurePlace place);

bool table_has_scene(const Table* table, int scene);

// The number of bodies above which OpenCL is always faster than the CPU at this place, and the ms of a step there. Returns 0
// if it is never faster, or at all sizes.
double table_crossover(const Table* table, int scene, int pipeline, FigurePlace place, double* ms);
void table_print_crossovers(const Table* table);

#endif
