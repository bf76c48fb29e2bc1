// SPDX-License-Identifier: MIT
// stroke.h -- lines and dots over a picture, collected and drawn with one call.
#ifndef STROKE_H
#define STROKE_H
#include "scene/sprites.h"
#include "view/camera.h"

typedef struct // 24 bytes, an instance
{
	scree_vec a, b; // ends, m; equal for a dot
	float width;    // px
	uint8_t color[4];
} Stroke;

typedef struct
{
	Stroke* list;
	int count, capacity;
	unsigned program, vertices, buffer; // OpenGL names
	int view, scale;                    // uniforms
} Strokes;

bool strokes_open(Strokes* strokes, char* sentence);
void strokes_close(Strokes* strokes);

// Adds a stroke, or nothing when memory is short. opacity is 0 to 255.
void strokes_add(Strokes* strokes, scree_vec a, scree_vec b, float width, Color color, int opacity);

// Draws all strokes and removes them.
void strokes_draw(Strokes* strokes, const Camera* camera);

#endif
