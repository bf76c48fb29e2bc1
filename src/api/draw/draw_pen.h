// SPDX-License-Identifier: MIT
// draw_pen.h -- hands lines, points, texts and shapes to the functions of a program, culled to a box.
#ifndef DRAW_PEN_H
#define DRAW_PEN_H
#include "api/draw/draw_rows.h"

typedef struct // all that the parts of a drawing need
{
	const scree_world* world;
	const DrawRows* rows;
	const scree_draw_def* def;
	scree_box view;
} Pen;

#define SMALL_POINT 3.0f // width of points, pixels
#define LARGE_POINT 6.0f

// Returns the color of the outline of a fill.
static inline uint32_t opaque(uint32_t color) { return color | 0xffu; }

static inline bool pen_draws(const Pen* pen, uint32_t flag) { return pen->def->flags & flag; }

void pen_line(const Pen* pen, scree_vec a, scree_vec b, uint32_t color);
void pen_point(const Pen* pen, scree_vec at, float pixels, uint32_t color);
void pen_shape(const Pen* pen, const scree_shape* shape, scree_pose pose, uint32_t color);

// Returns whether a text at a point would be drawn.
bool pen_labels(const Pen* pen, scree_vec at);

// Draw a text, and a number with three digits and a unit, if labels are drawn.
void pen_label(const Pen* pen, scree_vec at, const char* text, uint32_t color);
void pen_number(const Pen* pen, scree_vec at, float number, const char* unit, uint32_t color);

// Draws a line from a point in a direction, which need not have the length 1.
void pen_ray(const Pen* pen, scree_vec from, scree_vec direction, float length, uint32_t color);

#endif
