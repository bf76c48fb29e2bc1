// SPDX-License-Identifier: MIT
// viewport.h -- computes the part of a world that a picture shows.
#ifndef VIEWPORT_H
#define VIEWPORT_H
#include "platform/exact_floats.h"
#include "scree/scree.h"

#define BAND   36 // px: height of the caption at the bottom of a picture
#define MARGIN 12 // px: minimum space around the box that a picture shows

typedef struct
{
	double scale;        // px per m
	double left, bottom; // m: coordinates at the picture's left edge and at the top edge of the caption
} Viewport;

// Returns a viewport that shows a whole box in the middle of the picture. width, height: px.
Viewport viewport_show(scree_box view, int width, int height);

// Returns the view of a moving camera: at share 0 the box `from`, at share 1 the box `to`. Between these the scale
// changes at a constant rate, and one point of the world stays at its place in the picture.
scree_box viewport_between(scree_box from, scree_box to, double share);

// Finds a box around all points but the outermost 0.5 % in x and in y, and enlarges it by 2 * reach, m, at each side.
// Without points, the box extends from -1 to 1 m in x and y. Returns false if memory is short.
bool viewport_fit(const scree_vec* points, int count, float reach, scree_box* view);

#endif
