// SPDX-License-Identifier: MIT
// make_fields.c -- creates fields for tests, and bodies in fields.
#include "support/make_fields.h"

scree_field add_field(scree_world* world, const scree_field_def* def)
{
	scree_field field;
	OK(scree_field_create(world, def, &field));
	return field;
}

scree_body add_dense(scree_world* world, scree_shape shape, float density, float x, float y)
{
	scree_attribute_def def = surface_of(shape);
	def.density = density;
	return add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), x, y, 0.0f);
}
