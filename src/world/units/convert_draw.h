// SPDX-License-Identifier: MIT
// convert_draw.h -- converts debug draw and the shapes of listed collidables to a world's unit of length.
#ifndef CONVERT_DRAW_H
#define CONVERT_DRAW_H
#include "scree/scree.h"

typedef struct // functions of the program that draw, and the unit in which they draw
{
	scree_draw_def given;
	double unit;
} UnitPen;

// Replaces the functions of a definition by functions that convert points to the unit, and call those of the program. The pen
// outlives the call.
void units_draw(UnitPen* pen, scree_draw_def* def, double unit);

// Sets the shapes of listed collidables to shapes in the unit. states: rows of `size` bytes. Fails with SCREE_ERROR_OUT_OF_MEMORY.
scree_status units_shapes(scree_world* world, scree_collidable_state* states, size_t size, int count);

#endif
