// SPDX-License-Identifier: MIT
// body_mass.c -- reads and sets masses of bodies.
#include "platform/processor.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/mass.h"
#include "world/record/api_calls.h"
#include "world/world.h"

static scree_status check_read(const scree_world* world, const char* function, scree_body body, const scree_mass* mass)
{
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "mass", mass));
	return check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, &index);
}

scree_status api_body_get_mass(const scree_world* world, scree_body body, scree_mass* mass)
{
	FLOAT_MODE_HERE;
	TRY(check_read(world, "scree_body_get_mass", body, mass));
	*mass = mass_now(world, (int)body.index);
	return SCREE_OK;
}

scree_status api_body_get_own_mass(const scree_world* world, scree_body body, scree_mass* mass)
{
	FLOAT_MODE_HERE;
	TRY(check_read(world, "scree_body_get_own_mass", body, mass));
	*mass = world->host_bodies[body.index].own_mass;
	return SCREE_OK;
}

static scree_status check_mass(const scree_world* world, ArgumentPlace body, ArgumentPlace mass, scree_body handle,
                               scree_mass value)
{
	int index = 0;
	TRY(check_body(world, body, "", handle, &index));
	if (world->host_bodies[index].type != SCREE_BODY_DYNAMIC)
		return refuse(SCREE_ERROR_INVALID, body, "", "is not dynamic: it has no mass");
	TRY(check_real(mass, ".mass", value.mass, LEAST_MASS, MOST_MASS));
	if (value.inertia != 0.0f)
		TRY(check_real(mass, ".inertia (when it is not 0)", value.inertia, LEAST_INERTIA, MOST_MASS));
	return check_vec(mass, ".center", value.center, SCREE_MAX_COORDINATE);
}

scree_status api_body_set_mass(scree_world* world, scree_body body, scree_mass mass)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_mass";
	TRY(world_check(world, function));
	TRY(check_mass(world, (ArgumentPlace){function, "body", ALONE}, (ArgumentPlace){function, "mass", ALONE}, body,
	               mass));
	TRY(edits_reserve(world, function, 0, 0, 2));
	mass_own(world, (int)body.index, mass);
	return SCREE_OK;
}

scree_status api_bodies_set_masses(scree_world* world, const scree_body* bodies, const scree_mass* masses, int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_bodies_set_masses";
	TRY(world_check(world, function));
	TRY(check_batch(function, "bodies", bodies, count));
	TRY(check_batch(function, "masses", masses, count));
	for (int k = 0; k < count; ++k)
		TRY(check_mass(world, (ArgumentPlace){function, "bodies", k}, (ArgumentPlace){function, "masses", k}, bodies[k],
		               masses[k]));
	TRY(edits_reserve(world, function, 0, 0, 2 * count));
	for (int k = 0; k < count; ++k)
		mass_own(world, (int)bodies[k].index, masses[k]);
	return SCREE_OK;
}
