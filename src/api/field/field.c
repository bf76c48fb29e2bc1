// SPDX-License-Identifier: MIT
// field.c -- creates, changes, destroys and lists fields.
#include "api/field/field_wake.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/fields.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include <stdio.h>

#define MOST_STRENGTH 1e12f // maximum of strengths, drags, densities and the like, in SI units; it keeps results finite
#define LEAST_FALLOFF 1e-3f // m: minimum of scree_field_def.radius

void scree_field_def_default_sized(scree_field_def* def, size_t size, scree_field_type type)
{
	const scree_field_def made = {.size = (uint32_t)size,
	                              .type = type,
	                              .pose.rotation.c = 1.0f,
	                              .category = ~(uint64_t)0,
	                              .mask = ~(uint64_t)0,
	                              .strength = 10.0f,
	                              .falloff = SCREE_FALLOFF_INVERSE_SQUARE,
	                              .radius = 1.0f,
	                              .softening = 0.1f,
	                              .density = 1.0f,
	                              .drag = 1.0f,
	                              .linear_drag = type == SCREE_FIELD_BUOYANCY ? 2.0f : 0.0f};
	write_result(def, size, &made, sizeof made);
}

static scree_status check_region(ArgumentPlace at, scree_field_def* def)
{
	char argument[32];
	snprintf(argument, sizeof argument, "%s.shape", at.argument);
	if (def->shape.count != 0)
		TRY(shape_finish((ArgumentPlace){at.function, argument, ALONE}, &def->shape));
	if (def->type == SCREE_FIELD_BUOYANCY && def->shape.count != 0 &&
	    (def->shape.kind != SCREE_SHAPE_POLYGON || def->shape.radius > 0.0f))
		return refuse(SCREE_ERROR_INVALID, at, ".shape", "must be a polygon without rounding, or none");
	return SCREE_OK;
}

static scree_status check_def(const scree_world* world, const char* function, const scree_field_def* def,
                              scree_field_def* made, int* body)
{
	ArgumentPlace at = {function, "def", ALONE};
	scree_field_def local;
	TRY(check_pointer(function, "def", def));
	TRY(check_definition(at, def, 0, &field_definition));
	*made = *(const scree_field_def*)definition_at(def, 0, &field_definition, &local);
	if ((unsigned)made->type > SCREE_FIELD_BUOYANCY)
		return refuse(SCREE_ERROR_INVALID, at, ".type", "is %d, not a scree_field_type", (int)made->type);
	if ((unsigned)made->falloff > SCREE_FALLOFF_INVERSE_SQUARE)
		return refuse(SCREE_ERROR_INVALID, at, ".falloff", "is %d, not a scree_field_falloff", (int)made->falloff);
	*body = -1;
	if (!scree_body_is_null(made->body))
		TRY(check_body(world, at, ".body", made->body, body));
	TRY(check_pose(at, ".pose", &made->pose));
	TRY(check_region(at, made));
	TRY(check_vec(at, ".acceleration", made->acceleration, MOST_STRENGTH));
	TRY(check_vec(at, ".force", made->force, MOST_STRENGTH));
	TRY(check_vec(at, ".velocity", made->velocity, SCREE_MAX_COORDINATE));
	const struct
	{
		const char* member;
		float value, least, most;
	} numbers[] = {{".strength", made->strength, -MOST_STRENGTH, MOST_STRENGTH},
	               {".radius", made->radius, LEAST_FALLOFF, SCREE_MAX_COORDINATE},
	               {".softening", made->softening, 0.0f, SCREE_MAX_COORDINATE},
	               {".density", made->density, 0.0f, MOST_STRENGTH},
	               {".drag", made->drag, 0.0f, MOST_STRENGTH},
	               {".lift", made->lift, 0.0f, MOST_STRENGTH},
	               {".linear_drag", made->linear_drag, 0.0f, MOST_STRENGTH},
	               {".quadratic_drag", made->quadratic_drag, 0.0f, MOST_STRENGTH},
	               {".spin_drag", made->spin_drag, 0.0f, MOST_STRENGTH},
	               {".spin_drag_quadratic", made->spin_drag_quadratic, 0.0f, MOST_STRENGTH}};
	for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k)
		TRY(check_real(at, numbers[k].member, numbers[k].value, numbers[k].least, numbers[k].most));
	return SCREE_OK;
}

scree_status api_field_create(scree_world* world, const scree_field_def* def, scree_field* field)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_field_create";
	scree_field_def made;
	int body;
	TRY(world_check(world, function));
	TRY(check_def(world, function, def, &made, &body));
	TRY(fields_reserve(world, function));
	int index = field_make(world);
	field_put(world, index, &made, body);
	scree_status status = field_wake(world, index);
	if (status != SCREE_OK)
		field_remove(world, index);
	else if (field)
		*field = field_handle(world, index);
	return status;
}

static scree_status lookup(const scree_world* world, const char* function, scree_field field, int* index)
{
	TRY(world_check(world, function));
	return check_field(world, (ArgumentPlace){function, "field", ALONE}, field, index);
}

scree_status api_field_destroy(scree_world* world, scree_field field)
{
	FLOAT_MODE_HERE;
	int index = 0;
	TRY(lookup(world, "scree_field_destroy", field, &index));
	TRY(field_wake(world, index));
	field_remove(world, index);
	return SCREE_OK;
}

bool scree_field_is_valid(const scree_world* world, scree_field field) { return world && field_is_valid(world, field); }

scree_status api_field_set_def(scree_world* world, scree_field field, const scree_field_def* def)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_field_set_def";
	scree_field_def made;
	int index = 0, body;
	TRY(lookup(world, function, field, &index));
	TRY(check_def(world, function, def, &made, &body));
	TRY(field_wake(world, index));
	field_put(world, index, &made, body);
	return field_wake(world, index);
}

scree_status api_field_get_def_sized(const scree_world* world, scree_field field, scree_field_def* def, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_field_get_def";
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "def", def));
	TRY(check_field(world, (ArgumentPlace){function, "field", ALONE}, field, &index));
	scree_field_def known = world->fields.host[index].def;
	known.size = (uint32_t)size;
	write_result(def, size, &known, sizeof known);
	return SCREE_OK;
}

scree_status api_field_set_pose(scree_world* world, scree_field field, scree_pose pose)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_field_set_pose";
	int index = 0;
	TRY(lookup(world, function, field, &index));
	TRY(check_pose((ArgumentPlace){function, "pose", ALONE}, "", &pose));
	TRY(field_wake(world, index));
	world->fields.host[index].def.pose = pose;
	world->fields.stale = true;
	return field_wake(world, index);
}

scree_status api_field_set_enabled(scree_world* world, scree_field field, bool enabled)
{
	FLOAT_MODE_HERE;
	int index = 0;
	TRY(lookup(world, "scree_field_set_enabled", field, &index));
	TRY(field_wake(world, index)); // a field that is disabled wakes nothing, so only one of the two calls acts
	world->fields.host[index].def.disabled = !enabled;
	world->fields.stale = true;
	return field_wake(world, index);
}

scree_status api_world_get_fields(const scree_world* world, scree_field* fields, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_fields";
	int listed = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_list(function, "fields", fields, capacity, count));
	for (int k = 0; k < world->fields.slots.used; ++k)
	{
		if (!slots_in_use(&world->fields.slots, k))
			continue;
		if (listed < capacity)
			fields[listed] = field_handle(world, k);
		++listed;
	}
	*count = listed;
	return SCREE_OK;
}
