// SPDX-License-Identifier: MIT
// lod.h -- level of detail: selects the rows that are drawn as shapes and the rows that are drawn as splats, at a
// scale.
#ifndef LOD_H
#define LOD_H
#include "view/render_tables.h"

#define MAX_RUNS 64 // maximum number of draw calls; a further call takes longer than the rows between two ranges

typedef struct // a range of consecutive rows
{
	int first, count;
} Run;

typedef struct
{
	float scale, detail; // arguments of the last search by lod_update; scale 0: no search yet
	int rows;            // number of rows in the last search
	Run shapes[MAX_RUNS];
	int shape_runs;
	bool splats; // true if at least one attribute is drawn as splats
} Lod;

// Finds the ranges of shapes, unless rows, scale and detail are those of the last search. The ranges contain every row
// that is drawn as a shape, and some rows of splats, which the shader discards.
void lod_update(Lod* lod, const RenderTables* tables, int rows, float scale, float detail);

#endif
