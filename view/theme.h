// SPDX-License-Identifier: MIT
// theme.h -- defines all colors except those of dynamic bodies, for a light or a dark background.
#ifndef THEME_H
#define THEME_H
#include "scene/sprites.h"

typedef struct
{
	Color background, text;
	Color still;  // color of bodies that are not dynamic
	Color glass;  // color of outlines of collidables without a body
	Color ink;    // color of lines of velocities and dots of centers of mass
	Color idle;   // color of joints without load
	Color chosen; // color of the outline of the selected body
} Theme;

const Theme* theme_of(bool dark);

#endif
