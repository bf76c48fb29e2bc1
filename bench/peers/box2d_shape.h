// SPDX-License-Identifier: MIT
// box2d_shape.h -- adds a collidable of Scree to a body of Box2D.
#ifndef BOX2D_SHAPE_H
#define BOX2D_SHAPE_H
#include "scree/scree.h"
#include <box2d/box2d.h>

// Adds a shape, given in the body's frame, to a body. surface: attribute with the surface values; the shape in it is
// not used. The caller applies the mass afterwards. If Box2D has no such shape, prints a sentence and returns false.
bool box2d_add_shape(b2BodyId body, const scree_attribute_def* surface, const scree_shape* shape, scree_filter filter);

#endif
