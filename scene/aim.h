// SPDX-License-Identifier: MIT
// aim.h -- which part of a world a picture of some size shows.
#ifndef AIM_H
#define AIM_H
#include "scree/scree.h"

#define BAND   36 // px: height of the caption, at the bottom
#define MARGIN 12 // px around what is shown

typedef struct
{
	double scale;        // px per m
	double left, bottom; // m: the world at the picture's left edge, and above the caption
} Aim;

// Shows the whole of a box, in the middle.
Aim aim_at(scree_box view, int width, int height);

// The box around count points, reach wide around each, without the few that flew away. False when memory is short.
bool aim_fit(const scree_vec* points, int count, float reach, scree_box* view);

#endif
