// SPDX-License-Identifier: MIT
// style.h -- coloring of bodies, and the layers that are drawn over them.
#ifndef STYLE_H
#define STYLE_H
#include "scene/sprites.h"

typedef enum // rule that colors a body
{
#define X(enumerator, name, help) PAINT_##enumerator,
#include "view/paints.def"
#undef X
	PAINTS,
} Paint;

extern const char* const paint_names[PAINTS];

// Returns the index of a name in a list, -1 if it is not there.
int find_name(const char* const* names, int count, const char* text, size_t length);

#define GRAPH_COLORS 64 // number of values of scree_contact.color

// Returns the color for a graph color. Hues are a golden angle apart, so that consecutive colors differ; contacts of
// hubs are dark.
Color graph_color(int color);

typedef enum
{
#define X(name, key, shown, help) LAYER_##name,
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
	    // px: bodies with a smaller reach are splats, shorter joints are omitted; 1 is fine, 4 for a software renderer
	    detail;
	int rays;  // maximum number of rays of the scene that are drawn
	bool dark; // dark background
} Style;

// Reads the name of a paint and a list of layers, separated by commas. Null selects the default, which shows joints,
// sensors and rays. Returns false and writes a sentence (SENTENCE of shader.h) that begins with the option on failure.
bool style_read(Style* style, const char* paint, const char* layers, char* sentence);

#endif
