// SPDX-License-Identifier: MIT
// draw_pen.c -- hands lines, points, texts and shapes to the functions of a program, culled to a box.
#include "api/draw/draw_pen.h"
#include <math.h>
#include <stdio.h>

static bool is_visible(const Pen* pen, scree_vec at)
{
	return at.x >= pen->view.lower.x && at.x <= pen->view.upper.x && at.y >= pen->view.lower.y &&
	       at.y <= pen->view.upper.y;
}

void pen_line(const Pen* pen, scree_vec a, scree_vec b, uint32_t color)
{
	scree_box box = {{fminf(a.x, b.x), fminf(a.y, b.y)}, {fmaxf(a.x, b.x), fmaxf(a.y, b.y)}};
	bool dot = a.x == b.x && a.y == b.y;
	if (pen->def->line && !dot && draw_overlaps(&box, &pen->view))
		pen->def->line(a, b, color, pen->def->context);
}

void pen_ray(const Pen* pen, scree_vec from, scree_vec direction, float length, uint32_t color)
{
	pen_line(pen, from, (scree_vec){from.x + length * direction.x, from.y + length * direction.y}, color);
}

void pen_point(const Pen* pen, scree_vec at, float pixels, uint32_t color)
{
	if (pen->def->point && is_visible(pen, at))
		pen->def->point(at, pixels, color, pen->def->context);
}

bool pen_labels(const Pen* pen, scree_vec at)
{
	return pen->def->text && pen_draws(pen, SCREE_DRAW_LABELS) && is_visible(pen, at);
}

void pen_label(const Pen* pen, scree_vec at, const char* text, uint32_t color)
{
	if (pen_labels(pen, at))
		pen->def->text(at, text, opaque(color), pen->def->context);
}

void pen_number(const Pen* pen, scree_vec at, float number, const char* unit, uint32_t color)
{
	char text[48], plain[48];
	int length = 0;
	if (!pen_labels(pen, at))
		return;
	snprintf(text, sizeof text, "%.3g", (double)number);
	// the point of a locale may be another letter, or several bytes
	for (const char* c = text; *c; ++c)
	{
		bool digit = (*c >= '0' && *c <= '9') || *c == '-' || *c == '+' || *c == 'e';
		if (digit || (length > 0 && plain[length - 1] != '.'))
			plain[length++] = digit ? *c : '.';
	}
	snprintf(plain + length, sizeof plain - (size_t)length, " %s", unit);
	pen_label(pen, at, plain, color);
}

static void fill(const scree_draw_def* to, const scree_shape* shape, const scree_vec* vertices, uint32_t color)
{
	if (shape->count > 2 && to->polygon)
		to->polygon(vertices, shape->count, shape->radius, color, to->context);
	else if (shape->count == 2 && shape->radius > 0.0f && to->capsule)
		to->capsule(vertices[0], vertices[1], shape->radius, color, to->context);
	else if (shape->count == 1 && to->circle)
		to->circle(vertices[0], shape->radius, color, to->context);
}

void pen_shape(const Pen* pen, const scree_shape* shape, scree_pose pose, uint32_t color)
{
	scree_vec vertices[SCREE_MAX_VERTICES];
	if (!draw_is_near(shape, pose.position, &pen->view))
		return;
	scree_box box = draw_outline(shape, pose, vertices);
	if (!draw_overlaps(&box, &pen->view))
		return;
	fill(pen->def, shape, vertices, color);
	if (shape->count == 1)
		pen_ray(pen, vertices[0], (scree_vec){pose.rotation.c, pose.rotation.s}, shape->radius, opaque(color));
	else if (shape->count == 2 && shape->radius == 0.0f)
		pen_line(pen, vertices[0], vertices[1], opaque(color));
}
