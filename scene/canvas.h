// SPDX-License-Identifier: MIT
// canvas.h -- the pixels of a picture, its caption and its file, for the renderers of Cairo and OpenGL.
#ifndef CANVAS_H
#define CANVAS_H
#include "scene/scene.h"
#include "scene/sprites.h"
#include <stdio.h>

typedef struct
{
	int width, height; // px
	size_t stride;     // bytes from a row to the next
	uint8_t* pixels;   // four bytes each: blue, green, red, unused; rows from the top
	void *surface, *cairo;
} Canvas;

// False writes a sentence: this build has no Cairo, memory is short, or the size is out of range.
bool canvas_open(Canvas* canvas, int width, int height, char* sentence);
void canvas_close(Canvas* canvas);

// Draw the outline of a rectangle, and a line; px from the left and the top.
void canvas_mark(Canvas* canvas, double left, double top, double width, double height);
void canvas_line(Canvas* canvas, double x0, double y0, double x1, double y1);

// Draws the title in bold type and the caption into the band at the bottom. Fields of the caption have three spaces between
// them; the last ones are left out where the picture is narrow.
void canvas_caption(Canvas* canvas, const char* title, const char* caption);

// Writes the picture as PNG; false when writing fails.
bool canvas_write(Canvas* canvas, FILE* file);

#endif
