// SPDX-License-Identifier: MIT
// shades.h -- computes the colors of bodies: each attribute has a range of shades, which are distributed over the
// bodies of each block of the scene.
#ifndef SHADES_H
#define SHADES_H
#include "scene/scene.h"

typedef struct
{
	uint8_t r, g, b;
} Color;

#define SHADE_COUNT  63 // number of shades of an attribute; render_tables.h stores a shade in six bits
#define SHADE_MIDDLE 31

typedef struct
{
	Color first, middle, last; // colors of shade 0, SHADE_MIDDLE and SHADE_COUNT - 1
} Shades;

// Returns the shades of an entry of the palette. After its last entry, the palette repeats from its first. A negative
// entry has the single color of bodies that are not dynamic.
Shades shades_of(int entry);

// Returns the color of a shade, made a little lighter or darker depending on the index of the body, so that neighbors
// differ. row.glsl uses the same formula.
Color shades_color(const Shades* shades, int shade, uint32_t body);

#define ASLEEP_SHARE 0.4f // share of its own color in the color of a sleeping body; row.glsl uses the same number

// Returns the dim color of a sleeping body: a mixture with the color of the background.
Color shades_dim(Color color, Color background);

typedef struct // state of a loop over the bodies of a scene in the order of their indices
{
	const Scene* scene; // null: all bodies get the middle shade
	int block;
	int64_t first; // number of bodies in the blocks before this block
} ShadeWalk;

// Returns the shade of a body by its position in its block. Bodies that the scene did not create get the middle shade.
// The index must not be less than in the last call.
int shade_next(ShadeWalk* walk, uint32_t index);

#endif
