// SPDX-License-Identifier: MIT
// theme.h -- the colors of what is no body: on a light or a dark ground.
#ifndef THEME_H
#define THEME_H
#include "scene/sprites.h"

typedef struct
{
	Color background, text;
	Color still;  // bodies that are not dynamic
	Color glass;  // outlines of collidables without a body
	Color ink;    // velocities, centers of mass
	Color idle;   // joints without load
	Color chosen; // the outline of what is selected
} Theme;

const Theme* theme_of(bool dark);

#endif
