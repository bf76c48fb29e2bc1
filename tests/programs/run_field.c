// SPDX-License-Identifier: MIT
// run_field.c -- makes the calls of fields, and reads the state of fields.
#include "programs/run_call.h"

static scree_field call_field(const CallRun* r)
{
	int k = call_whole(r, "field");
	return k >= 0 && k < MOST_NAMES ? r->names->fields[k] : SCREE_NULL_FIELD;
}

// Creates a field, or redefines an existing field.
static scree_status run_make(const CallRun* r)
{
	scree_field_def def = scree_field_def_default((scree_field_type)call_whole(r, "type"));
	int k = call_whole(r, "field"), body = call_whole(r, "body"), attribute = call_whole(r, "attribute");
	if (body >= 0)
		def.body = call_body(r, body);
	if (attribute >= 0 && attribute < MOST_NAMES)
	{
		scree_attribute_def shaped;
		scree_status status = scree_attribute_get_def(r->world, r->names->attributes[attribute], &shaped);
		if (status != SCREE_OK)
			return status;
		def.shape = shaped.shape;
	}
	def.pose = call_pose(r);
	def.strength = call_real(r, "strength");
	def.falloff = (scree_field_falloff)call_whole(r, "falloff");
	def.radius = call_real(r, "radius");
	def.softening = call_real(r, "softening");
	def.acceleration = call_vec(r, "ax", "ay");
	def.force = call_vec(r, "fx", "fy");
	def.velocity = call_vec(r, "vx", "vy");
	def.density = call_real(r, "density");
	def.drag = call_real(r, "drag");
	def.lift = call_real(r, "lift");
	def.linear_drag = call_real(r, "linear");
	def.quadratic_drag = call_real(r, "quadratic");
	def.spin_drag = def.spin_drag_quadratic = call_real(r, "spin");
	def.mask = (uint64_t)call_whole(r, "mask");
	if (k < 0 || k >= MOST_NAMES)
		return scree_field_create(r->world, &def, NULL);
	if (scree_field_is_valid(r->world, r->names->fields[k]))
		return scree_field_set_def(r->world, r->names->fields[k], &def);
	return scree_field_create(r->world, &def, r->names->fields + k);
}

scree_status run_field(const CallRun* r)
{
	switch (r->call->kind)
	{
	case CALL_field:
		return run_make(r);
	case CALL_field_destroy:
		return scree_field_destroy(r->world, call_field(r));
	case CALL_field_pose:
		return scree_field_set_pose(r->world, call_field(r), call_pose(r));
	default:
		return scree_field_set_enabled(r->world, call_field(r), call_whole(r, "enabled") != 0);
	}
}

scree_status clear_fields(const CallRun* r)
{
	static scree_field fields[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_fields(r->world, fields, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
		status = scree_field_destroy(r->world, fields[k]);
	return status;
}

scree_status read_fields(const CallRun* r, uint64_t* word)
{
	static scree_field fields[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_fields(r->world, fields, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
	{
		scree_field_def def;
		status = scree_field_get_def(r->world, fields[k], &def);
		*word = hash_words(hash_words(*word, &def.pose, sizeof def.pose), &def.strength, sizeof def.strength);
	}
	*word = hash_words(*word, &count, sizeof count);
	return status;
}
