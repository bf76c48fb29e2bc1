// SPDX-License-Identifier: MIT
// curve.h -- measures a pipeline on a device with a world of one size: a point on a curve of a figure.
#ifndef CURVE_H
#define CURVE_H
#include "cli/common/options.h"
#include "tools/paper/figure.h"
#include <stdio.h>

typedef struct // a pipeline on a device, measured at several sizes
{
	FigurePipeline pipeline;
	FigurePlace place;
	const char* device; // argument of --device
	int threads;        // argument of --threads
	char label[160];    // name of the device in the CSV
	int threads_used;
	double bodies, ms; // number of bodies in the last measured world, and ms of a step
	bool ended;        // true: steps of larger worlds would take too long
} Curve;

typedef struct // the hash that a pipeline must have on all devices, for a world of one size
{
	uint64_t hash;
	const char* device; // device on which the hash was measured first; null: not measured yet
} CommonHash;

typedef struct
{
	const Options* options;
	FILE* csv;
	int number; // number of the figure: 5 or 6
	int scene;
	char settings[64]; // settings of the scene as text for the CSV
	const char* gpu;   // argument of --device for the GPU; null: no GPU
	double begin;      // s: start of the measurements
	int rows;
} Figure;

// Measures a row and prints it to the CSV. expected: estimated ms of a step. Returns an exit code.
int curve_measure(Figure* figure, Curve* curve, CommonHash* common, const Options* sized, double expected);

// Returns the estimated ms of a step with this number of bodies, based on the last measured size; 0 before the first
// measurement.
double curve_estimate(const Curve* curve, int bodies);

// Prints a row without measured steps: ms is the estimate of a step.
void curve_print_estimate(Figure* figure, const Curve* curve, int bodies, double ms);

#endif
