// SPDX-License-Identifier: MIT
// lod.h -- level of detail: selects the rows that are drawn as shapes and the rows that are drawn as splats, at a
// scale.
#ifndef LOD_H
#define LOD_H
#include "view/render_tables.h"

#define MAX_RUNS 64 // maximum number of draw calls; one more takes longer than drawing the rows between two ranges

typedef struct // a range of consecutive rows
{
	int first, count;
} Run;

typedef struct
{
	float scale, detail; // arguments of lod_update for which the ranges were found; scale 0: not found yet
	int rows;            // number of rows for which the ranges were found
	Run shapes[MAX_RUNS];
	int shape_runs;
	bool splats; // true if at least one attribute is drawn as splats
} Lod;

// Finds the ranges of shapes if rows, scale or detail differ from those of the last search. The ranges contain every
// row that is drawn as a shape, and some splats, which the shader discards.
void lod_update(Lod* lod, const RenderTables* tables, int rows, float scale, float detail);

#endif
