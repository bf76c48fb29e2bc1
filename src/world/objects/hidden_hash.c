// SPDX-License-Identifier: MIT
// hidden_hash.c -- computes the part of the hash of a world that only the host has.
#include "world/objects/hidden_hash.h"
#include "pools/hash_types.h"
#include "world/objects/exclusions.h"
#include "world/objects/fields.h"
#include "world/objects/materials.h"
#include "world/objects/reports.h"
#include "world/pool_values.h"
#include "world/world.h"

static Word64 hash_pose(Word64 h, scree_pose pose) { return hash_float4(h, pose_row(pose)); }

uint64_t hidden_hash_disabled(const scree_world* world, int body)
{
	const HostBody* host = world->host_bodies + body;
	return hash_float(hash_word(hash_begin(HASH_DISABLED, body), (Word)host->type), host->values.gravity_scale);
}

uint64_t hidden_hash_collidable(const scree_world* world, int index, int attribute)
{
	const HostCollidable* c = world->host_collidables + index;
	Word64 h = hash_word(hash_word(hash_begin(HASH_DISABLED_COLLIDABLE, index), (Word)c->body), (Word)attribute);
	return hash_Filter(hash_pose(h, c->pose), filter_row(c->filter, report_bits(c)));
}

// Hashes type, gravity scale and collidables of a disabled body, which the device does not hash.
static Word64 hash_disabled(const scree_world* world, int body)
{
	Word64 sum = hidden_hash_disabled(world, body);
	for (int k = world->host_bodies[body].first_collidable; k >= 0; k = world->host_collidables[k].next)
		sum += hidden_hash_collidable(world, k, world->host_collidables[k].attribute);
	return sum;
}

uint64_t hidden_hash_mass(int body, scree_mass mass)
{
	return hash_float4(hash_begin(HASH_OWN_MASS, body),
	                   make_float4(mass.mass, mass.inertia, mass.center.x, mass.center.y));
}

uint64_t hidden_hash_target(int body, scree_pose pose) { return hash_pose(hash_begin(HASH_TARGET, body), pose); }

uint64_t hidden_hash_rest(const scree_world* world)
{
	Word64 sum = 0;
	for (int k = 0; k < world->paths.used; ++k)
		if (slots_in_use(&world->paths, k))
			sum += hash_mix(hash_begin(HASH_PATH, k) + world->host_paths[k].name);
	return sum + materials_hash(world) + exclusions_hash(world) + allowed_hash(world) + fields_hash(world);
}

uint64_t world_hidden_hash(const scree_world* world)
{
	Word64 sum = hidden_hash_rest(world);
	for (int k = 0; k < world->bodies.used && world->disabled_bodies > 0; ++k)
		if (slots_in_use(&world->bodies, k) && world->host_bodies[k].disabled)
			sum += hash_disabled(world, k);
	for (int k = 0; k < world->bodies.used && world->own_masses; ++k)
		if (slots_in_use(&world->bodies, k) && world->host_bodies[k].own_mass.mass > 0.0f)
			sum += hidden_hash_mass(k, world->host_bodies[k].own_mass);
	for (int k = 0; k < world->target_count; ++k)
		sum += hidden_hash_target(world->targets[k].body, world->targets[k].pose);
	for (int k = 0; k < world->sensors.visit_count; ++k)
		sum += hash_mix(
		    hash_int(hash_begin(HASH_VISIT, world->sensors.visits[k].sensor), world->sensors.visits[k].visitor));
	return sum;
}
