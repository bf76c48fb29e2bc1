// SPDX-License-Identifier: MIT
// ramp.h -- the colors of bodies: each attribute has a ramp of them, which the bodies of an entry of the scene run through.
#ifndef RAMP_H
#define RAMP_H
#include "scene/scene.h"

typedef struct
{
	uint8_t r, g, b;
} Color;

#define SHADES       63 // places on a ramp: six bits of a byte of render_tables.h
#define SHADE_MIDDLE 31

typedef struct
{
	Color first, middle, last; // at the places 0, SHADE_MIDDLE and SHADES - 1
} Ramp;

// The ramp of an entry of the palette, which begins again at its end; -1 is that of bodies that are not dynamic, of one color.
Ramp ramp_of(int entry);

// A color of a ramp, a little lighter or darker by the index of the body, so that equal neighbors differ; row.glsl has the same formula.
Color ramp_color(const Ramp* ramp, int shade, uint32_t body);

typedef struct // walks over the bodies of a scene in the order of their indices
{
	const Scene* scene; // null: all bodies have the middle of their ramp
	int block;
	int64_t first; // body of the block
} ShadeWalk;

// The place of a body on its ramp: how far it is from the first body of its entry to the last. Bodies that the scene did not make
// have the middle. The indices must not fall from call to call.
int shade_next(ShadeWalk* walk, uint32_t index);

#endif
