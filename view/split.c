// SPDX-License-Identifier: MIT
// split.c -- which rows are drawn as shapes and which as blots, at the scale of a picture.
//
// A few walls around a hundred thousand blots are a few rows: without the split the pass of shapes would look at all of
// them, four times each. Rows come in the order in which bodies were made, so that those of one kind stand together.
#include "view/split.h"

#define NEAR 256 // rows between two runs that are not worth another draw

static bool is_blot(const Look* look, int attribute, float scale, float detail)
{
	const scree_shape* shape = &look->attributes[attribute].shape;
	return shape->area > 0.0f && shape->reach * scale < detail;
}

static void add_row(Split* split, int row)
{
	Run* last = split->shape_runs > 0 ? &split->shapes[split->shape_runs - 1] : NULL;
	if (last && (row - last->first - last->count < NEAR || split->shape_runs == MAX_RUNS))
		last->count = row + 1 - last->first;
	else
		split->shapes[split->shape_runs++] = (Run){row, 1};
}

void split_rows(Split* split, const Look* look, int rows, float scale, float detail)
{
	if (split->rows == rows && split->scale == scale && split->detail == detail)
		return;
	*split = (Split){.scale = scale, .detail = detail, .rows = rows};
	int blots = 0;
	for (int k = 0; k < look->attribute_count; ++k)
		blots += is_blot(look, k, scale, detail);
	split->blots = blots > 0;
	if (blots == 0 && rows > 0)
		split->shapes[split->shape_runs++] = (Run){0, rows};
	for (int row = 0; row < rows && blots > 0; ++row)
	{
		int attribute = row < look->row_count ? look->row_attributes[row] : -1;
		if (row >= look->row_count || (attribute >= 0 && !is_blot(look, attribute, scale, detail)))
			add_row(split, row);
	}
}
