// SPDX-License-Identifier: MIT
// canvas.h -- stores the pixels of a picture, draws caption and legend into them, and writes the file. The renderers of
// Cairo and OpenGL use it.
#ifndef CANVAS_H
#define CANVAS_H
#include "scene/scene.h"
#include "scene/sprites.h"
#include <stdio.h>

typedef struct
{
	int width, height; // px
	size_t stride;     // bytes from one row of pixels to the next
	uint8_t* pixels;   // four bytes each: blue, green, red, unused; rows from the top
	void *surface, *cairo;
	Color background, text; // colors of the caption
} Canvas;

#define LEGEND_COLORS 24

typedef struct // explanation of the colors of a picture, with numbers and units
{
	char title[64]; // title with the unit
	bool blocks;    // true: separate colors; false: colors change evenly
	int color_count;
	Color low[LEGEND_COLORS], high[LEGEND_COLORS]; // colors at the bottom and at the top of the color bar
	int tick_count;
	struct
	{
		float at; // position in the color bar: 0 left, 1 right
		char text[20];
	} ticks[LEGEND_COLORS];
} Legend;

// Opens a canvas. Returns false and writes an error message if this build has no Cairo, memory is short, or the size is
// out of range.
bool canvas_open(Canvas* canvas, int width, int height, char* sentence);
void canvas_close(Canvas* canvas);

// canvas_mark draws the outline of a rectangle, canvas_line draws a line. Coordinates: px from the left and the top.
void canvas_mark(Canvas* canvas, double left, double top, double width, double height);
void canvas_line(Canvas* canvas, double x0, double y0, double x1, double y1);

// Draws the title in bold type and the caption into the band at the bottom. Fields of the caption are separated by
// three spaces; in a narrow picture the last fields are omitted.
void canvas_caption(Canvas* canvas, const char* title, const char* caption);

// Draws a legend above the caption, at the right. Small pictures get no legend.
void canvas_legend(Canvas* canvas, const Legend* legend);

// Writes the picture as PNG. Returns false if writing fails.
bool canvas_write(Canvas* canvas, FILE* file);

#endif
