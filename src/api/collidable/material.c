// SPDX-License-Identifier: MIT
// material.c -- sets and reads surface values of pairs of materials, which replace values mixed from two attributes.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/materials.h"
#include "world/record/api_calls.h"
#include "world/upload/whole_sleep.h"
#include <math.h>

void scree_material_pair_default_sized(scree_material_pair* pair, size_t size)
{
	scree_material_pair made = {.size = (uint32_t)size, .friction = NAN, .restitution = NAN, .tangent_speed = NAN};
	write_result(pair, size, &made, sizeof made);
}

static scree_status check_material(const char* function, const char* argument, int material)
{
	if (material >= 0 && material < MATERIALS)
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, argument, ALONE}, "", "is %d, must be from 0 to %d",
	              material, MATERIALS - 1);
}

// Checks a value and adds `bit` to *sets (MaterialPair.sets). NaN means that the value is not set: it adds no bit.
static scree_status check_part(ArgumentPlace at, const char* member, float value, float low, float high, int bit,
                               int* sets)
{
	if (isnan(value))
		return SCREE_OK;
	*sets |= bit;
	return check_real(at, member, value, low, high);
}

scree_status api_world_set_material_pair(scree_world* world, int material_a, int material_b,
                                         const scree_material_pair* pair)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_set_material_pair";
	ArgumentPlace at = {function, "pair", ALONE};
	TRY(world_check(world, function));
	TRY(check_material(function, "material_a", material_a));
	TRY(check_material(function, "material_b", material_b));
	MaterialPair row = {0};
	if (pair)
	{
		scree_material_pair local;
		TRY(check_definition(at, pair, 0, &material_definition));
		const scree_material_pair* def = definition_at(pair, 0, &material_definition, &local);
		row.sets = def->ignored ? MATERIAL_IGNORED : 0;
		TRY(check_part(at, ".friction", def->friction, 0.0f, MOST_SURFACE, MATERIAL_FRICTION, &row.sets));
		TRY(check_part(at, ".restitution", def->restitution, 0.0f, MOST_RESTITUTION, MATERIAL_RESTITUTION, &row.sets));
		TRY(check_part(at, ".tangent_speed", def->tangent_speed, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE,
		               MATERIAL_SPEED, &row.sets));
		// adding zero makes a negative zero positive
		row.friction = row.sets & MATERIAL_FRICTION ? def->friction + 0.0f : 0.0f;
		row.restitution = row.sets & MATERIAL_RESTITUTION ? def->restitution + 0.0f : 0.0f;
		row.tangent_speed = row.sets & MATERIAL_SPEED ? 0.0f - def->tangent_speed : 0.0f;
	}
	if (!material_changes(world, material_a, material_b, &row))
		return SCREE_OK; // so that a call in each step keeps no body awake
	TRY(world_set_awake(world, true));
	return material_set(world, function, material_a, material_b, row);
}

scree_status api_world_get_material_pair_sized(const scree_world* world, int material_a, int material_b,
                                               scree_material_pair* pair, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_material_pair";
	TRY(check_pointer(function, "world", world));
	TRY(check_material(function, "material_a", material_a));
	TRY(check_material(function, "material_b", material_b));
	TRY(check_pointer(function, "pair", pair));
	MaterialPair row = material_row(world, material_a, material_b);
	scree_material_pair known = {.size = (uint32_t)size,
	                             .friction = row.sets & MATERIAL_FRICTION ? row.friction : NAN,
	                             .restitution = row.sets & MATERIAL_RESTITUTION ? row.restitution : NAN,
	                             .tangent_speed = row.sets & MATERIAL_SPEED ? 0.0f - row.tangent_speed : NAN,
	                             .ignored = (row.sets & MATERIAL_IGNORED) != 0};
	write_result(pair, size, &known, sizeof known);
	return SCREE_OK;
}
