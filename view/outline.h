// SPDX-License-Identifier: MIT
// outline.h -- draws the outline of a shape with strokes.
#ifndef OUTLINE_H
#define OUTLINE_H
#include "view/stroke.h"

// Adds the outline of a shape at a pose. width: line width, px.
void outline_mark(Strokes* strokes, const scree_shape* shape, scree_pose pose, const Camera* camera, float width,
                  Color color);

#endif
