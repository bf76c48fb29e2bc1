// SPDX-License-Identifier: MIT
// make_fields.h -- fields of tests, and bodies in them.
#ifndef MAKE_FIELDS_H
#define MAKE_FIELDS_H
#include "support/make_bodies.h"

scree_field add_field(scree_world* world, const scree_field_def* def);

// Adds a dynamic body with one collidable and its own density.
scree_body add_dense(scree_world* world, scree_shape shape, float density, float x, float y);

#endif
