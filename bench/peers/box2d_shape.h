// SPDX-License-Identifier: MIT
// box2d_shape.h -- a collidable of Scree as a shape of Box2D.
#ifndef BOX2D_SHAPE_H
#define BOX2D_SHAPE_H
#include "scree/scree.h"
#include <box2d/box2d.h>

// Adds a shape, in the body's frame, with the other values of the surface; masses are the caller's to apply. Returns
// false after printing that Box2D has no such shape.
bool box2d_add_shape(b2BodyId body, const scree_attribute_def* surface, const scree_shape* shape, scree_filter filter);

#endif
