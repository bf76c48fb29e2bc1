// SPDX-License-Identifier: MIT
// table.h -- reads the rows of a figure's CSV, and computes the crossovers of its curves.
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
	double bodies, ms; // number of bodies in the world; ms of a step
	bool run;          // true: `ms` was measured; false: `ms` is an estimate
	double stages[FIGURE_STAGE_COUNT];
	char device[64]; // name in the figures: "1 thread", "NVIDIA H200"
} Row;

typedef struct
{
	Row rows[MAX_ROWS];
	int count;
	char processor[64]; // name from machine.txt beside the CSV: "Intel Xeon"; without this file "CPU"
} Table;

// Reads a CSV. Returns an exit code; prints a message if it failed.
int table_read(const char* csv, Table* table);

// Writes the full name of a row's device: "NVIDIA H200, OpenCL", "Intel Xeon, 16 threads".
void table_device(const Table* table, const Row* row, char* text, size_t size);

// Returns the row of a curve that follows the row `after` (null: the first row), or null at the end of the curve.
const Row* table_next(const Table* table, const Row* after, int scene, int pipeline, FigurePlace place);

bool table_has_scene(const Table* table, int scene);

// Returns the number of bodies above which OpenCL is always faster than the CPU with the threads of `place`, and writes
// the ms of a step with this number of bodies. Returns 0 if there is none, because the CPU is at least as fast at the
// largest measured size, or OpenCL is faster at all sizes.
double table_crossover(const Table* table, int scene, int pipeline, FigurePlace place, double* ms);
void table_print_crossovers(const Table* table);

#endif
