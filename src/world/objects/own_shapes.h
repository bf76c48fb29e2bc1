// SPDX-License-Identifier: MIT
// own_shapes.h -- makes the attributes of a batch of collidables that own their shapes.
#ifndef OWN_SHAPES_H
#define OWN_SHAPES_H
#include "world/check.h"

// Checks the definitions of `count` own shapes. `argument` is "shape" if the call has one shape, else "shapes".
scree_status own_shapes_check(const char* function, const char* argument, const scree_attribute_def* shapes, int count,
                              bool alone);

// Makes the attributes of checked shapes, and writes their slots to `attributes`. On failure there are no new attributes.
scree_status own_shapes_make(scree_world* world, const char* function, const scree_attribute_def* shapes, int count,
                             int* attributes);

// Ends those of the attributes that no collidable uses, because the call failed.
void own_shapes_settle(scree_world* world, const int* attributes, int count);

#endif
