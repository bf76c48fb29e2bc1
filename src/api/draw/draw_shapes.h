// SPDX-License-Identifier: MIT
// draw_shapes.h -- draws fields, collidables and their enlarged boxes.
#ifndef DRAW_SHAPES_H
#define DRAW_SHAPES_H
#include "api/draw/draw_pen.h"

void draw_fields(const Pen* pen);

// Draws the solid collidables, or those that only report: sensors, and collidables without a body.
void draw_collidables(const Pen* pen, bool solid);
void draw_boxes(const Pen* pen);

#endif
