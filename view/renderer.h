// SPDX-License-Identifier: MIT
// renderer.h -- draws a world from rows in a buffer of OpenGL: bodies, and what may lie over them.
#ifndef RENDERER_H
#define RENDERER_H
#include "view/look.h"
#include "view/share.h"
#include "view/split.h"
#include "view/stroke.h"

typedef enum // what colors a body; row.glsl knows the numbers
{
	PAINT_ATTRIBUTE,
	PAINT_SPEED,
	PAINT_GRAPH, // the lowest color of its contacts
	PAINTS,
} Paint;

// "attribute", "speed", "graph"
extern const char* const paint_names[PAINTS];

#define GRAPH_COLORS 64 // of scree_contact.color

// Hues a golden angle apart, so that neighbors in the list can be told apart; contacts of hubs are dark.
Color graph_color(int color);

typedef enum
{
#define X(name, help) LAYER_##name,
#include "view/layers.def"
#undef X
	LAYERS,
} Layer;

extern const char* const layer_names[LAYERS];

typedef struct
{
	Paint paint;
	bool layers[LAYERS];
	bool graph;   // contact points in the color that the solver takes them in
	float detail; // px: bodies of less reach are blots; 1 is fine, 4 spares a software renderer
} Style;

// Reads the name of a paint and those of layers with commas between them; null leaves either as it is by default. Returns
// false and writes a sentence (SENTENCE of shader.h) that begins with the option.
bool style_read(Style* style, const char* paint, const char* layers, char* sentence);

typedef struct // a program of OpenGL with its uniforms
{
	unsigned program;
	int view, scale, paint, least, size, line, coarse;
} Pass;

typedef struct
{
	Pass body, blot, box, velocity;
	unsigned one_each, four_each; // vertex arrays: a row is a vertex, or an instance
	Strokes strokes;
	Look look;
	Split split;
	scree_contact* contacts;
	int contact_count, contact_room;
	bool software; // OpenGL runs on the CPU
} Renderer;

// Wants a current context of OpenGL 3.3. Leaves a sentence (SENTENCE of shader.h) when it cannot.
bool renderer_open(Renderer* renderer, char* sentence);
void renderer_close(Renderer* renderer);

// What is in the world has changed; also to begin with.
bool renderer_look(Renderer* renderer, scree_world* world);

// Fetches what a style shows besides the rows: velocities, contacts.
scree_status renderer_fetch(Renderer* renderer, const Style* style);

// Draws into the current framebuffer, paper included. Strokes that were added before lie on top.
void renderer_draw(Renderer* renderer, const Share* share, const Camera* camera, const Style* style);

#endif
