// SPDX-License-Identifier: MIT
// shades.h -- the colors of bodies: each attribute has a shades of them, which the bodies of an entry of the scene run through.
#ifndef SHADES_H
#define SHADES_H
#include "scene/scene.h"

typedef struct
{
	uint8_t r, g, b;
} Color;

#define SHADE_COUNT  63 // of an attribute: six bits of a byte of render_tables.h
#define SHADE_MIDDLE 31

typedef struct
{
	Color first, middle, last; // at the places 0, SHADE_MIDDLE and SHADE_COUNT - 1
} Shades;

// The shades of an entry of the palette, which begins again at its end; -1 is that of bodies that are not dynamic, of one color.
Shades shades_of(int entry);

// A color of a shades, a little lighter or darker by the index of the body, so that equal neighbors differ; row.glsl has the same formula.
Color shades_color(const Shades* shades, int shade, uint32_t body);

typedef struct // walks over the bodies of a scene in the order of their indices
{
	const Scene* scene; // null: all bodies have the middle of their shades
	int block;
	int64_t first; // body of the block
} ShadeWalk;

// The shade of a body: how far it is from the first body of its entry to the last. Bodies that the scene did not make
// have the middle. The indices must not fall from call to call.
int shade_next(ShadeWalk* walk, uint32_t index);

#endif
