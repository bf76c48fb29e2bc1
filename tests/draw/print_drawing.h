// SPDX-License-Identifier: MIT
// print_drawing.h -- prints fills, lines and texts, for the stand-ins of drawing libraries in this folder.
#ifndef PRINT_DRAWING_H
#define PRINT_DRAWING_H
#include <stddef.h>
#include <stdio.h>

// Prints the number of points and the area in square pixels; an area above 0 is counter-clockwise as seen on the screen.
// stride: bytes from a point to the next.
static inline void print_fill(const float* first, size_t stride, int count, int r, int g, int b, int a)
{
	double area = 0.0;
	for (int k = 0; k < count; ++k)
	{
		const float* p = (const float*)((const char*)first + stride * (size_t)k);
		const float* q = (const float*)((const char*)first + stride * (size_t)((k + 1) % count));
		area += 0.5 * ((double)q[0] * p[1] - (double)p[0] * q[1]);
	}
	printf("fill %d %.0f %02x%02x%02x%02x\n", count, area, r, g, b, a);
}

static inline void print_line(float ax, float ay, float bx, float by, int r, int g, int b, int a)
{
	printf("line %.0f,%.0f %.0f,%.0f %02x%02x%02x%02x\n", (double)ax, (double)ay, (double)bx, (double)by, r, g, b, a);
}

static inline void print_text(const char* text, float x, float y, int r, int g, int b, int a)
{
	printf("text %.0f,%.0f %s %02x%02x%02x%02x\n", (double)x, (double)y, text, r, g, b, a);
}

#endif
