// SPDX-License-Identifier: MIT
// draw_raylib.h -- draws a world with raylib, between BeginDrawing and EndDrawing: view_draw with raylib_view.
#ifndef DRAW_RAYLIB_H
#define DRAW_RAYLIB_H
#include "draw_view.h"
#include <raylib.h>

static void raylib_fill(const scree_vec* points, int count, uint32_t color, void* target)
{
	(void)target;
	DrawTriangleFan((const Vector2*)points, count, GetColor(color)); // both structs have the members x and y
}

static void raylib_line(scree_vec a, scree_vec b, uint32_t color, void* target)
{
	(void)target;
	DrawLine((int)a.x, (int)a.y, (int)b.x, (int)b.y, GetColor(color));
}

static void raylib_text(scree_vec at, const char* text, uint32_t color, void* target)
{
	(void)target;
	DrawText(text, (int)at.x, (int)at.y - 10, 10, GetColor(color));
}

// Returns a view of this size around the point (0, 0).
static inline DrawView raylib_view(float width, float height, float scale)
{
	DrawView view = {{0.0f, 0.0f}, scale, width, height, NULL, raylib_fill, raylib_line, raylib_text};
	return view;
}

#endif
