// SPDX-License-Identifier: MIT
// split.h -- which rows are drawn as shapes and which as blots, at the scale of a picture.
#ifndef SPLIT_H
#define SPLIT_H
#include "view/look.h"

#define MAX_RUNS 64 // more cost more than the rows between them

typedef struct // of rows, one after the other
{
	int first, count;
} Run;

typedef struct
{
	float scale, detail; // that it was made for; scale 0: for none
	int rows;            // drawn
	Run shapes[MAX_RUNS];
	int shape_runs;
	bool blots; // there are any
} Split;

// Brings the split up to date. Runs of shapes hold every row of a shape, and perhaps others, which the shader drops.
void split_rows(Split* split, const Look* look, int rows, float scale, float detail);

#endif
