// SPDX-License-Identifier: MIT
// style.h -- the style of a picture: the coloring of bodies, and the layers over them.
#ifndef STYLE_H
#define STYLE_H
#include "scene/sprites.h"

typedef enum // rules for the colors of bodies
{
#define X(enumerator, name, help) PAINT_##enumerator,
#include "view/paints.def"
#undef X
	PAINTS,
} Paint;

extern const char* const paint_names[PAINTS];

// Returns the index of a name in a list; -1 if the list does not contain the name.
int find_name(const char* const* names, int count, const char* text, size_t length);

#define GRAPH_COLORS 64 // number of possible values of scree_contact.color

// Returns the color in which a graph color is drawn. Hues of consecutive graph colors differ by the golden angle; the
// graph color of hubs is dark.
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
	bool graph;   // true: contact points are drawn in the graph color of their contact
	float detail; // px: bodies of less reach are splats, shorter joints are omitted; 1, or 4 if OpenGL is slow
	int rays;     // maximum number of rays of the scene that are drawn
	bool dark;    // true: dark background
} Style;

// Reads the name of a paint, and a list of layers with commas between them. Null selects the default: colors by
// attribute; joints, fields, sensors and rays. On failure returns false and writes a sentence (SENTENCE of shader.h)
// that begins with the option.
bool style_read(Style* style, const char* paint, const char* layers, char* sentence);

#endif
