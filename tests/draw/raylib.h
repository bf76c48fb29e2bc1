// SPDX-License-Identifier: MIT
// raylib.h -- declares that which examples/draw/draw_raylib.h uses of raylib, for tests without it: functions that print.
#ifndef RAYLIB_H
#define RAYLIB_H
#include "print_drawing.h"

typedef struct Vector2
{
	float x, y;
} Vector2;

typedef struct Color
{
	unsigned char r, g, b, a;
} Color;

static inline Color GetColor(unsigned int c)
{
	Color color = {(unsigned char)(c >> 24), (unsigned char)(c >> 16), (unsigned char)(c >> 8), (unsigned char)c};
	return color;
}

static inline void DrawTriangleFan(const Vector2* points, int count, Color c)
{
	print_fill(&points->x, sizeof *points, count, c.r, c.g, c.b, c.a);
}

static inline void DrawLine(int ax, int ay, int bx, int by, Color c)
{
	print_line((float)ax, (float)ay, (float)bx, (float)by, c.r, c.g, c.b, c.a);
}

static inline void DrawText(const char* text, int x, int y, int size, Color c)
{
	(void)size;
	print_text(text, (float)x, (float)y, c.r, c.g, c.b, c.a);
}

#endif
