// SPDX-License-Identifier: MIT
// theme.h -- defines colors other than those of dynamic bodies, for a light or a dark background.
#ifndef THEME_H
#define THEME_H
#include "scene/sprites.h"

typedef struct
{
	Color background, text;
	Color still;  // bodies that are not dynamic
	Color glass;  // outlines of collidables without a body
	Color ink;    // lines of velocities, dots of centers of mass
	Color idle;   // joints without load
	Color chosen; // outline of the selected body
} Theme;

const Theme* theme_of(bool dark);

#endif
