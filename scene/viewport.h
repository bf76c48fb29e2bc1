// SPDX-License-Identifier: MIT
// viewport.h -- the part of a world that a picture of some size shows.
#ifndef VIEWPORT_H
#define VIEWPORT_H
#include "scree/scree.h"

#define BAND   36 // px: height of the caption, at the bottom
#define MARGIN 12 // px around the box that is shown

typedef struct
{
	double scale;        // px per m
	double left, bottom; // m: coordinates at the picture's left edge and at the top edge of the caption
} Viewport;

// Shows a whole box in the middle of the picture.
Viewport viewport_show(scree_box view, int width, int height);

// Returns the view of a moving camera: at share 0 one box, at share 1 the other. The picture grows at a steady rate
// around one point.
scree_box viewport_between(scree_box from, scree_box to, double share);

// Finds a box around the points, 2 * reach larger at each side, without the outermost 0.5 % in x and in y. Returns
// false if memory is short.
bool viewport_fit(const scree_vec* points, int count, float reach, scree_box* view);

#endif
