// SPDX-License-Identifier: MIT
// lod.h -- level of detail: which rows are drawn as shapes and which as splats, at the scale of a picture.
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
	float scale, detail; // that the runs are for; scale 0: none
	int rows;            // drawn, in total
	Run shapes[MAX_RUNS];
	int shape_runs;
	bool splats; // whether any row is a splat
} Lod;

// Finds the runs anew if an argument changed. They hold every row of a shape, and some others, which the shader discards.
void lod_update(Lod* lod, const RenderTables* tables, int rows, float scale, float detail);

#endif
