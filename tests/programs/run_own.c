// SPDX-License-Identifier: MIT
// run_own.c -- makes the calls of bodies and collidables that own their shapes, and of surfaces.
#include "programs/run_call.h"

scree_attribute_def call_surface(const CallRun* r, scree_shape shape)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.shape = shape;
	def.density = call_real(r, "density");
	def.friction = call_real(r, "friction");
	def.restitution = call_real(r, "restitution");
	def.rolling_resistance = call_real(r, "rolling");
	def.tangent_speed = call_real(r, "tangent");
	def.one_way = call_vec(r, "way_x", "way_y");
	def.material = call_whole(r, "material");
	return def;
}

// Reads the shape of attribute `of`.
static scree_status read_shape(const CallRun* r, scree_attribute_def* def)
{
	scree_attribute_def known = scree_attribute_def_default();
	scree_status status = scree_attribute_get_def(r->world, call_attribute(r, "of"), &known);
	*def = call_surface(r, known.shape);
	return status;
}

// Creates one body, or a row of bodies, of which each second one is heavier.
static scree_status create_bodies(const CallRun* r)
{
	static scree_body_def defs[MOST_BATCH];
	static scree_attribute_def shapes[MOST_BATCH];
	scree_attribute_def shape;
	scree_status status = read_shape(r, &shape);
	int first = call_whole(r, "body"), count = call_batch(r, "body"), one = call_whole(r, "count") == 0;
	if (status != SCREE_OK || first < 0 || first >= MOST_NAMES)
		return status;
	for (int k = 0; k < count + one; ++k)
	{
		shapes[k] = shape;
		shapes[k].density *= (float)(1 + k % 2);
		defs[k] = scree_body_def_default();
		defs[k].type = (scree_body_type)call_whole(r, "type");
		defs[k].pose = call_pose(r);
		defs[k].pose.position.x += (float)k * call_real(r, "dx");
		defs[k].velocity = (scree_velocity){call_vec(r, "vx", "vy"), call_real(r, "w")};
		defs[k].asleep = call_whole(r, "asleep") != 0;
		defs[k].disabled = call_whole(r, "disabled") != 0;
		defs[k].user = (uint64_t)first;
	}
	scree_body made = r->names->bodies[first];
	if (!one)
		return scree_bodies_create_with_shapes(r->world, defs, shapes, count,
		                                       r->names->bodies + (count > 0 ? first : 0));
	status = scree_body_create_with_shape(r->world, defs, shapes, &made);
	r->names->bodies[first] = made;
	return status;
}

static scree_status create_collidable(const CallRun* r)
{
	scree_collidable_def def = scree_collidable_def_default();
	scree_attribute_def shape;
	scree_status status = read_shape(r, &shape);
	if (status != SCREE_OK)
		return status;
	scree_collidable made = {0, 0};
	if (call_real(r, "body") >= 0.0f)
		def.body = call_body(r, call_whole(r, "body"));
	def.pose = call_pose(r);
	status = scree_collidable_create_with_shape(r->world, &def, &shape, &made);
	int k = call_whole(r, "collidable");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->collidables[k] = made;
	return status;
}

static scree_status change_surface(const CallRun* r)
{
	scree_surface surface = scree_surface_default();
	surface.friction = call_real(r, "friction");
	surface.restitution = call_real(r, "restitution");
	surface.rolling_resistance = call_real(r, "rolling");
	surface.tangent_speed = call_real(r, "tangent");
	return scree_collidable_set_surface(r->world, call_collidable(r), &surface);
}

// Gives the attribute of a collidable a number, so that later calls share it, or try to destroy it.
static scree_status adopt(const CallRun* r)
{
	scree_attribute found = {0, 0};
	scree_status status = scree_collidable_get_attribute(r->world, call_collidable(r), &found);
	int k = call_whole(r, "attribute");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->attributes[k] = found;
	return status;
}

scree_status run_own(const CallRun* r)
{
	switch (r->call->kind)
	{
	case CALL_own_bodies:
		return create_bodies(r);
	case CALL_own_collidable:
		return create_collidable(r);
	case CALL_surface:
		return change_surface(r);
	default:
		return adopt(r);
	}
}
