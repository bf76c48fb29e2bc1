// SPDX-License-Identifier: MIT
// field_support.h -- short ways to make fields and bodies in them.
#ifndef FIELD_SUPPORT_H
#define FIELD_SUPPORT_H
#include "support.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static inline scree_field_def field_def(scree_field_type type) { return scree_field_def_default(type); }

static inline scree_field add_field(scree_world* world, const scree_field_def* def)
{
	scree_field field;
	OK(scree_field_create(world, def, &field));
	return field;
}

static inline scree_pose at(float x, float y) { return (scree_pose){{x, y}, {1.0f, 0.0f}}; }

// A body of one collidable with a density of its own.
static inline scree_body add_dense(scree_world* world, scree_shape shape, float density, float x, float y)
{
	scree_attribute_def def = surface_of(shape);
	def.density = density;
	return add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), x, y, 0.0f);
}

static inline scree_shape capsule_shape(float half, float radius)
{
	scree_shape shape;
	OK(scree_shape_make_capsule((scree_vec){-half, 0.0f}, (scree_vec){half, 0.0f}, radius, &shape));
	return shape;
}

static inline void push_off(scree_world* world, scree_body body, float x, float y, float w)
{
	OK(scree_body_set_velocity(world, body, (scree_velocity){{x, y}, w}));
}

#endif
