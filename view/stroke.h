// SPDX-License-Identifier: MIT
// stroke.h -- lines and dots over a picture, collected and drawn with one call.
#ifndef STROKE_H
#define STROKE_H
#include "scene/sprites.h"
#include "view/camera.h"

typedef struct // 28 bytes, an instance
{
	scree_vec a, b; // endpoints, m; equal for a dot
	float width;    // px; the diameter of a ring
	uint8_t color[4];
	uint8_t end;  // opacity at b
	uint8_t ring; // line width of a ring in quarters of a pixel, 0: filled
	uint8_t unused[2];
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

// Adds a stroke whose opacity changes from begin at a to end at b.
void strokes_fade(Strokes* strokes, scree_vec a, scree_vec b, float width, Color color, int begin, int end);

// Adds a circle around a point; diameter and line width in px.
void strokes_ring(Strokes* strokes, scree_vec at, float diameter, float width, Color color, int opacity);

// Draws all strokes and removes them.
void strokes_draw(Strokes* strokes, const Camera* camera);

#endif
