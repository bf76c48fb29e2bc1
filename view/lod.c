// SPDX-License-Identifier: MIT
// lod.c -- level of detail: selects the rows that are drawn as shapes and the rows that are drawn as splats, at a
// scale.
//
// A scene may have a few walls and 100,000 splats. If all rows were one range, the program for shapes would process
// each of them, four vertices per row. Rows are in the order in which bodies were created, so rows of shapes are mostly
// consecutive.
#include "view/lod.h"

#define NEAR 256 // two ranges with fewer rows between them are merged

static bool is_splat(const RenderTables* tables, int attribute, float scale, float detail)
{
	const scree_shape* shape = &tables->attributes[attribute].shape;
	return shape->area > 0.0f && shape->reach * scale < detail;
}

static void add_row(Lod* lod, int row)
{
	Run* last = lod->shape_runs > 0 ? &lod->shapes[lod->shape_runs - 1] : NULL;
	if (last && (row - last->first - last->count < NEAR || lod->shape_runs == MAX_RUNS))
		last->count = row + 1 - last->first;
	else
		lod->shapes[lod->shape_runs++] = (Run){row, 1};
}

void lod_update(Lod* lod, const RenderTables* tables, int rows, float scale, float detail)
{
	if (lod->rows == rows && lod->scale == scale && lod->detail == detail)
		return;
	*lod = (Lod){.scale = scale, .detail = detail, .rows = rows};
	int splats = 0;
	for (int k = 0; k < tables->attribute_count; ++k)
		splats += is_splat(tables, k, scale, detail);
	lod->splats = splats > 0;
	if (splats == 0 && rows > 0)
		lod->shapes[lod->shape_runs++] = (Run){0, rows};
	for (int row = 0; row < rows && splats > 0; ++row)
	{
		int attribute = row < tables->row_count ? tables->row_attributes[row] : -1;
		if (row >= tables->row_count || (attribute >= 0 && !is_splat(tables, attribute, scale, detail)))
			add_row(lod, row);
	}
}
