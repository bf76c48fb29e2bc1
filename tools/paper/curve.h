// SPDX-License-Identifier: MIT
// curve.h -- measures one curve of a figure, a pipeline on a device, at one size.
#ifndef CURVE_H
#define CURVE_H
#include "cli/common/options.h"
#include "tools/paper/figure.h"
#include <stdio.h>

typedef struct // a pipeline on a device, from size to size
{
	FigurePipeline pipeline;
	FigurePlace place;
	const char* device; // as for --device
	int threads;        // as for --threads
	char label[160];    // the device, as in the CSV
	int threads_used;
	double bodies, ms; // size and time of a step in the last row
	bool ended;        // larger sizes would take too long
} Curve;

typedef struct // the hash that all devices must have at one size
{
	uint64_t hash;
	const char* device; // the first that was measured; null before it
} CommonHash;

typedef struct
{
	const Options* options;
	FILE* csv;
	int number; // 5 or 6
	int scene;
	char settings[64]; // those of the scene, as in the CSV
	const char* gpu;   // as for --device; null for none
	double begin;      // s
	int rows;
} Figure;

// Measures a row and prints it to the CSV. expected: ms of a step. Returns an exit code.
int curve_measure(Figure* figure, Curve* curve, CommonHash* common, const Options* sized, double expected);

// The expected ms of a step with this many bodies, from the last row; 0 before the first.
double curve_estimate(const Curve* curve, int bodies);

// Prints a row of no steps with the expected ms of a step.
void curve_print_estimate(Figure* figure, const Curve* curve, int bodies, double ms);

#endif
