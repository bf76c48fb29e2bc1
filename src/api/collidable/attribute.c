// SPDX-License-Identifier: MIT
// attribute.c -- creates one attribute for equal definitions, and destroys it after as many destructions as creations.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/attributes.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/world.h"
#include <string.h>

// Bounds of densities. Within them, every mass has a finite inverse, and every sum of masses is finite.
#define LEAST_DENSITY 1e-6f // kg/m^2
#define MOST_DENSITY  1e9f

#define LEAST_DIRECTION 1e-3f // minimum length of a vector that gives a direction

void scree_attribute_def_default_sized(scree_attribute_def* def, size_t size)
{
	scree_attribute_def made = {.size = (uint32_t)size, .density = 1.0f, .friction = 0.6f};
	scree_shape_make_box(0.5f, 0.5f, &made.shape);
	write_result(def, size, &made, sizeof made);
}

// Checks a definition, and replaces it by its canonical form: equal definitions then have equal bytes.
static scree_status check_def(const char* function, scree_attribute_def* def)
{
	ArgumentPlace at = {function, "def", ALONE};
	TRY(shape_finish((ArgumentPlace){function, "def.shape", ALONE}, &def->shape));
	if (def->density != 0.0f)
		TRY(check_real(at, ".density (when it is not 0)", def->density, LEAST_DENSITY, MOST_DENSITY));
	TRY(check_real(at, ".friction", def->friction, 0.0f, MOST_SURFACE));
	TRY(check_real(at, ".restitution", def->restitution, 0.0f, MOST_RESTITUTION));
	TRY(check_real(at, ".rolling_resistance", def->rolling_resistance, 0.0f, MOST_SURFACE));
	TRY(check_real(at, ".tangent_speed", def->tangent_speed, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE));
	TRY(check_vec(at, ".one_way", def->one_way, SCREE_MAX_COORDINATE));
	if (def->material < 0 || def->material >= MATERIALS)
		return refuse(SCREE_ERROR_INVALID, at, ".material", "is %d, must be from 0 to %d", def->material,
		              MATERIALS - 1);
	if (def->one_way.x * def->one_way.x + def->one_way.y * def->one_way.y < LEAST_DIRECTION * LEAST_DIRECTION &&
	    (def->one_way.x != 0.0f || def->one_way.y != 0.0f))
		return refuse(SCREE_ERROR_INVALID, at, ".one_way", "is (%s, %s), too short for a direction: at least %s",
		              decimal(def->one_way.x).text, decimal(def->one_way.y).text, decimal(LEAST_DIRECTION).text);
	// adding zero makes a negative zero positive
	scree_attribute_def plain;
	memset(&plain, 0, sizeof plain);
	plain.shape = def->shape;
	plain.density = def->density + 0.0f;
	plain.friction = def->friction + 0.0f;
	plain.restitution = def->restitution + 0.0f;
	plain.rolling_resistance = def->rolling_resistance + 0.0f;
	plain.tangent_speed = def->tangent_speed + 0.0f;
	plain.one_way = (scree_vec){def->one_way.x + 0.0f, def->one_way.y + 0.0f};
	plain.material = def->material;
	plain.size = sizeof plain;
	*def = plain;
	return SCREE_OK;
}

scree_status api_attribute_create(scree_world* world, const scree_attribute_def* def, scree_attribute* attribute)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_attribute_create";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "def", def));
	TRY(check_pointer(function, "attribute", attribute));
	TRY(check_definition((ArgumentPlace){function, "def", ALONE}, def, 0, &attribute_definition));
	scree_attribute_def local;
	scree_attribute_def plain = *(const scree_attribute_def*)definition_at(def, 0, &attribute_definition, &local);
	TRY(check_def(function, &plain));
	int index = 0;
	TRY(attribute_claim(world, function, &plain, &index));
	*attribute = attribute_handle(world, index);
	return SCREE_OK;
}

scree_status scree_attribute_get_def_sized(const scree_world* world, scree_attribute attribute,
                                           scree_attribute_def* def, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_attribute_get_def";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "def", def));
	int index = 0;
	TRY(check_attribute(world, (ArgumentPlace){function, "attribute", ALONE}, "", attribute, &index));
	scree_attribute_def known = world->attributes[index];
	known.size = (uint32_t)size;
	write_result(def, size, &known, sizeof known);
	return SCREE_OK;
}

scree_status api_attribute_destroy(scree_world* world, scree_attribute attribute)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_attribute_destroy";
	TRY(world_check(world, function));
	int index = 0;
	ArgumentPlace at = {function, "attribute", ALONE};
	TRY(check_attribute(world, at, "", attribute, &index));
	const HostAttribute* host = world->host_attributes + index;
	if (host->claims == 1 && host->collidables > 0)
		return refuse(SCREE_ERROR_INVALID, at, "", "(index %u) is still used by %d collidable%s", attribute.index,
		              host->collidables, host->collidables == 1 ? "" : "s");
	attribute_disclaim(world, index);
	return SCREE_OK;
}

bool scree_attribute_is_valid(const scree_world* world, scree_attribute attribute)
{
	return world && attribute_is_valid(world, attribute);
}
