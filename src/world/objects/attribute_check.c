// SPDX-License-Identifier: MIT
// attribute_check.c -- checks definitions of attributes and surfaces.
#include "world/objects/attribute_check.h"
#include "pools/pools.h"
#include "world/definition.h"
#include "world/shape/geometry.h"
#include <stdio.h>
#include <string.h>

// Bounds of densities. Within them, every mass has a finite inverse, and every sum of masses is finite.
#define LEAST_DENSITY 1e-6f // kg/m^2
#define MOST_DENSITY  1e9f

#define LEAST_DIRECTION 1e-3f // minimum length of a vector that gives a direction

scree_status surface_check(ArgumentPlace at, const scree_surface* surface, scree_attribute_def* plain)
{
	TRY(check_real(at, ".friction", surface->friction, 0.0f, MOST_SURFACE));
	TRY(check_real(at, ".restitution", surface->restitution, 0.0f, MOST_RESTITUTION));
	TRY(check_real(at, ".rolling_resistance", surface->rolling_resistance, 0.0f, MOST_SURFACE));
	TRY(check_real(at, ".tangent_speed", surface->tangent_speed, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE));
	// adding zero makes a negative zero positive
	plain->friction = surface->friction + 0.0f;
	plain->restitution = surface->restitution + 0.0f;
	plain->rolling_resistance = surface->rolling_resistance + 0.0f;
	plain->tangent_speed = surface->tangent_speed + 0.0f;
	return SCREE_OK;
}

static scree_status check_rule(ArgumentPlace at, const scree_attribute_def* def)
{
	TRY(check_vec(at, ".one_way", def->one_way, SCREE_MAX_COORDINATE));
	if (def->material < 0 || def->material >= MATERIALS)
		return refuse(SCREE_ERROR_INVALID, at, ".material", "is %d, must be from 0 to %d", def->material,
		              MATERIALS - 1);
	if (def->one_way.x * def->one_way.x + def->one_way.y * def->one_way.y < LEAST_DIRECTION * LEAST_DIRECTION &&
	    (def->one_way.x != 0.0f || def->one_way.y != 0.0f))
		return refuse(SCREE_ERROR_INVALID, at, ".one_way", "is (%s, %s), too short for a direction: at least %s",
		              decimal(def->one_way.x).text, decimal(def->one_way.y).text, decimal(LEAST_DIRECTION).text);
	return SCREE_OK;
}

scree_status attribute_check(ArgumentPlace at, const scree_attribute_def* defs, int k, scree_attribute_def* plain)
{
	TRY(check_definition(at, defs, k, &attribute_definition));
	scree_attribute_def local;
	const scree_attribute_def* def = definition_at(defs, k, &attribute_definition, &local);
	memset(plain, 0, sizeof *plain);
	plain->size = sizeof *plain;
	plain->shape = def->shape;
	char name[48], index[16] = "";
	if (at.index != ALONE)
		snprintf(index, sizeof index, "[%d]", at.index);
	snprintf(name, sizeof name, "%s%s.shape", at.argument, index);
	TRY(shape_finish((ArgumentPlace){at.function, name, ALONE}, &plain->shape));
	if (def->density != 0.0f)
		TRY(check_real(at, ".density (when it is not 0)", def->density, LEAST_DENSITY, MOST_DENSITY));
	const scree_surface surface = {.friction = def->friction,
	                               .restitution = def->restitution,
	                               .rolling_resistance = def->rolling_resistance,
	                               .tangent_speed = def->tangent_speed};
	TRY(surface_check(at, &surface, plain));
	TRY(check_rule(at, def));
	plain->density = def->density + 0.0f;
	plain->one_way = (scree_vec){def->one_way.x + 0.0f, def->one_way.y + 0.0f};
	plain->material = def->material;
	return SCREE_OK;
}
