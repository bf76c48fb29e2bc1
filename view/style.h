// SPDX-License-Identifier: MIT
// style.h -- how bodies are colored and which layers are drawn over them.
#ifndef STYLE_H
#define STYLE_H
#include "scene/sprites.h"

typedef enum // what colors a body
{
#define X(enumerator, name, help) PAINT_##enumerator,
#include "view/paints.def"
#undef X
	PAINTS,
} Paint;

extern const char* const paint_names[PAINTS];
int find_name(const char* const* names, int count, const char* text, size_t length); // -1 where there is none

#define GRAPH_COLORS 64 // of scree_contact.color

// The hues are a golden angle apart, so that consecutive colors differ; contacts of hubs are dark.
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
	bool graph; // contact points have the color of the solver's graph
	float
	    detail; // px: bodies of less reach are splats, shorter joints are left out; 1 is fine, 4 for a software renderer
	int rays;   // of the scene, that are drawn at most
	bool dark;  // on a dark ground
} Style;

// Reads the name of a paint and a list of layers with commas between them; null: the default, which shows joints, sensors and rays.
// False writes a sentence (SENTENCE of shader.h) that begins with the option.
bool style_read(Style* style, const char* paint, const char* layers, char* sentence);

#endif
