// SPDX-License-Identifier: MIT
// lod.h -- level of detail: selects the rows that are drawn as shapes and as splats, at the scale of a picture.
#ifndef LOD_H
#define LOD_H
#include "view/render_tables.h"

#define MAX_RUNS 64 // more draw calls cost more than drawing the rows between the runs

typedef struct // consecutive rows
{
	int first, count;
} Run;

typedef struct
{
	float scale, detail; // arguments for which the runs were found; scale 0: none yet
	int rows;            // total number of rows that are drawn
	Run shapes[MAX_RUNS];
	int shape_runs;
	bool splats; // true if any row is a splat
} Lod;

// Finds the runs again if an argument changed. They contain every row that is drawn as a shape, and some others, which
// the shader discards.
void lod_update(Lod* lod, const RenderTables* tables, int rows, float scale, float detail);

#endif
