// SPDX-License-Identifier: MIT
// run_field.c -- the calls of fields, and what can be read of them.
#include "programs/run_call.h"

static scree_field call_field(const Turn* t)
{
	int k = call_whole(t, "field");
	return k >= 0 && k < MOST_NAMES ? t->names->fields[k] : SCREE_NULL_FIELD;
}

// A new field, or another one in place of one that is there.
static scree_status run_make(const Turn* t)
{
	scree_field_def def = scree_field_def_default((scree_field_type)call_whole(t, "type"));
	int k = call_whole(t, "field"), body = call_whole(t, "body"), attribute = call_whole(t, "attribute");
	if (body >= 0)
		def.body = call_body(t, body);
	if (attribute >= 0 && attribute < MOST_NAMES)
	{
		scree_attribute_def shaped;
		scree_status status = scree_attribute_get_def(t->world, t->names->attributes[attribute], &shaped);
		if (status != SCREE_OK)
			return status;
		def.shape = shaped.shape;
	}
	def.pose = call_pose(t);
	def.strength = call_real(t, "strength");
	def.falloff = (scree_field_falloff)call_whole(t, "falloff");
	def.radius = call_real(t, "radius");
	def.softening = call_real(t, "softening");
	def.acceleration = call_vec(t, "ax", "ay");
	def.force = call_vec(t, "fx", "fy");
	def.velocity = call_vec(t, "vx", "vy");
	def.density = call_real(t, "density");
	def.drag = call_real(t, "drag");
	def.lift = call_real(t, "lift");
	def.linear_drag = call_real(t, "linear");
	def.quadratic_drag = call_real(t, "quadratic");
	def.spin_drag = def.spin_drag_quadratic = call_real(t, "spin");
	def.mask = (uint64_t)call_whole(t, "mask");
	if (k < 0 || k >= MOST_NAMES)
		return scree_field_create(t->world, &def, NULL);
	if (scree_field_is_valid(t->world, t->names->fields[k]))
		return scree_field_set_def(t->world, t->names->fields[k], &def);
	return scree_field_create(t->world, &def, t->names->fields + k);
}

scree_status run_field(const Turn* t)
{
	switch (t->call->kind)
	{
	case CALL_field:
		return run_make(t);
	case CALL_field_destroy:
		return scree_field_destroy(t->world, call_field(t));
	case CALL_field_pose:
		return scree_field_set_pose(t->world, call_field(t), call_pose(t));
	default:
		return scree_field_set_enabled(t->world, call_field(t), call_whole(t, "enabled") != 0);
	}
}

scree_status clear_fields(const Turn* t)
{
	static scree_field fields[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_fields(t->world, fields, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
		status = scree_field_destroy(t->world, fields[k]);
	return status;
}

scree_status read_fields(const Turn* t, uint64_t* word)
{
	static scree_field fields[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_fields(t->world, fields, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
	{
		scree_field_def def;
		status = scree_field_get_def(t->world, fields[k], &def);
		*word = read_mixed(read_mixed(*word, &def.pose, sizeof def.pose), &def.strength, sizeof def.strength);
	}
	*word = read_mixed(*word, &count, sizeof count);
	return status;
}
