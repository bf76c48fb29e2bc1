// SPDX-License-Identifier: MIT
// make_fields.h -- creates fields for tests, and bodies in fields.
#ifndef MAKE_FIELDS_H
#define MAKE_FIELDS_H
#include "support/make_bodies.h"

scree_field add_field(scree_world* world, const scree_field_def* def);

// Adds a dynamic body with one collidable of a given density.
scree_body add_dense(scree_world* world, scree_shape shape, float density, float x, float y);

#endif
