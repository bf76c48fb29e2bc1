// SPDX-License-Identifier: MIT
// stroke.h -- collects lines and dots over a picture, and draws them with one call.
#ifndef STROKE_H
#define STROKE_H
#include "scene/sprites.h"
#include "view/camera.h"

typedef struct // 28 bytes; drawn as one instance
{
	scree_vec a, b; // m: endpoints, which are equal for a dot or a ring
	float width;    // px: width of a line or dot, diameter of a ring
	uint8_t color[4];
	uint8_t end;  // opacity at endpoint b, 0 to 255; color[3] is the opacity at endpoint a
	uint8_t ring; // line width of a ring in quarters of a pixel; 0: a line or a dot
	uint8_t unused[2];
} Stroke;

typedef struct
{
	Stroke* list;
	int count, capacity;
	unsigned program, vertices, buffer; // names of OpenGL objects
	int view, scale;                    // locations of uniforms
} Strokes;

bool strokes_open(Strokes* strokes, char* sentence);
void strokes_close(Strokes* strokes);

// Adds a stroke; adds nothing if memory is short. opacity: 0 to 255.
void strokes_add(Strokes* strokes, scree_vec a, scree_vec b, float width, Color color, int opacity);

// Adds a stroke whose opacity changes from `begin` at endpoint a to `end` at endpoint b, both 0 to 255.
void strokes_fade(Strokes* strokes, scree_vec a, scree_vec b, float width, Color color, int begin, int end);

// Adds a circle around a point. diameter: px; width: line width, px; opacity: 0 to 255.
void strokes_ring(Strokes* strokes, scree_vec at, float diameter, float width, Color color, int opacity);

// Draws all strokes and removes them.
void strokes_draw(Strokes* strokes, const Camera* camera);

#endif
