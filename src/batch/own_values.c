// SPDX-License-Identifier: MIT
// own_values.c -- reads the own values of a world, and gives them to ordinary worlds.
#include "batch/own_values.h"
#include "platform/error.h"
#include "world/edits.h"
#include "world/objects/attributes.h"
#include "world/objects/handles.h"
#include "world/objects/hidden_hash.h"
#include "world/objects/mass.h"
#include <string.h>

size_t own_bytes(int bodies, int collidables, int joints)
{
	size_t bytes =
	    sizeof(OwnBody) * (size_t)bodies + sizeof(OwnCollidable) * (size_t)collidables + sizeof(int) * (size_t)joints;
	return (bytes + 15) / 16 * 16;
}

Own own_view(char* bytes, int bodies, int collidables, int joints)
{
	Own own = {.body = (OwnBody*)(void*)bytes, .bodies = bodies, .collidables = collidables, .joints = joints};
	own.collidable = (OwnCollidable*)(void*)(own.body + bodies);
	own.joint = (int*)(own.collidable + collidables);
	return own;
}

static bool same_core(const scree_attribute_def* a, const scree_attribute_def* b)
{
	return memcmp(&a->shape, &b->shape, sizeof a->shape) == 0 && a->density == b->density &&
	       a->one_way.x == b->one_way.x && a->one_way.y == b->one_way.y && a->material == b->material;
}

static void read_collidables(const scree_world* world, Own own, const OwnRules* rules)
{
	for (int k = 0; k < own.collidables; ++k)
	{
		rules->core[k] = slots_in_use(&world->collidables, k) ? k : -1;
		if (rules->core[k] < 0)
			continue;
		int attribute = world->host_collidables[k].attribute;
		const scree_attribute_def* def = world->attributes + attribute;
		rules->attribute[k] = attribute;
		own.collidable[k] =
		    (OwnCollidable){def->friction, def->restitution, def->rolling_resistance, def->tangent_speed, attribute};
		for (int n = 0; n < k && rules->core[k] == k; ++n)
			if (rules->core[n] == n && same_core(def, world->attributes + world->host_collidables[n].attribute))
				rules->core[k] = n;
	}
}

scree_status own_read(const scree_world* world, const char* function, int joints, char** bytes, OwnRules* rules)
{
	int bodies = world->bodies.used, collidables = world->collidables.used;
	*rules = (OwnRules){.attributes = world->attribute_slots.used};
	*bytes = scree_allocate(own_bytes(bodies, collidables, joints) + 1);
	rules->core = scree_allocate(sizeof(int) * (size_t)(collidables + 1));
	rules->attribute = scree_allocate(sizeof(int) * (size_t)(collidables + 1));
	rules->claimed = scree_allocate((size_t)rules->attributes + 1);
	if (!*bytes || !rules->core || !rules->attribute || !rules->claimed)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for the masses and surfaces of a world", function);
	Own own = own_view(*bytes, bodies, collidables, joints);
	for (int k = 0; k < bodies; ++k)
		if (slots_in_use(&world->bodies, k))
			own.body[k] = (OwnBody){world->host_bodies[k].own_mass, world->host_bodies[k].disabled};
	for (int k = 0; k < rules->attributes; ++k)
		rules->claimed[k] = slots_in_use(&world->attribute_slots, k) && world->host_attributes[k].claims > 0;
	read_collidables(world, own, rules);
	for (int k = 0; k < joints; ++k)
		if (k < world->joints.used && slots_in_use(&world->joints, k))
			own.joint[k] = (world->host_joints[k].def.disabled ? OWN_JOINT_DISABLED : 0) |
			               (world->host_joints[k].spot >= 0 ? OWN_JOINT_CHAINED : 0);
	return SCREE_OK;
}

void own_rules_close(OwnRules* rules)
{
	scree_release(rules->core);
	scree_release(rules->attribute);
	scree_release(rules->claimed);
	*rules = (OwnRules){0};
}

static bool is_claimed(const OwnRules* rules, int attribute)
{
	return attribute < rules->attributes && rules->claimed[attribute];
}

// Returns the lowest index of an attribute that no collidable has and no call has made.
static int free_attribute(Own own, const OwnRules* rules)
{
	for (int index = 0;; ++index)
	{
		bool used = is_claimed(rules, index);
		for (int k = 0; k < own.collidables && !used; ++k)
			used = own.collidable[k].attribute == index && rules->core[k] >= 0;
		if (!used)
			return index;
	}
}

bool own_set_surface(Own own, const OwnRules* rules, int index, const float surface[4])
{
	OwnCollidable now;
	for (int k = 0; k < 4; ++k)
		(&now.friction)[k] = surface[k] + 0.0f; // a negative zero becomes positive
	if (memcmp(&now, own.collidable + index, 4 * sizeof(float)) == 0)
		return false;
	now.attribute = -1;
	for (int k = 0; k < own.collidables && now.attribute < 0; ++k)
		if (rules->core[k] == rules->core[index] && !is_claimed(rules, own.collidable[k].attribute) &&
		    memcmp(&now, own.collidable + k, 4 * sizeof(float)) == 0)
			now.attribute = own.collidable[k].attribute;
	if (now.attribute < 0)
		now.attribute = free_attribute(own, rules);
	own.collidable[index] = now;
	return true;
}

uint64_t own_hash(const scree_world* world, Own own)
{
	uint64_t sum = 0;
	for (int k = 0; k < own.bodies; ++k)
	{
		if (own.body[k].mass.mass > 0.0f)
			sum += hidden_hash_mass(k, own.body[k].mass);
		if (!own.body[k].disabled)
			continue;
		sum += hidden_hash_disabled(world, k);
		for (int n = world->host_bodies[k].first_collidable; n >= 0; n = world->host_collidables[n].next)
			sum += hidden_hash_collidable(world, n, own.collidable[n].attribute);
	}
	return sum;
}

// Gives a collidable an attribute with another surface, at an index that is free or has this attribute.
static scree_status put_surface(scree_world* world, const char* function, int index, const OwnCollidable* own,
                                const scree_attribute_def* core)
{
	HostCollidable* host = world->host_collidables + index;
	const Slots* slots = &world->attribute_slots;
	if (own->attribute >= slots->used || !slots_in_use(slots, own->attribute))
	{
		scree_attribute_def def = *core;
		def.friction = own->friction;
		def.restitution = own->restitution;
		def.rolling_resistance = own->rolling_resistance;
		def.tangent_speed = own->tangent_speed;
		TRY(attribute_put(world, function, &def, own->attribute));
	}
	attribute_attach(world, own->attribute);
	host->attribute = own->attribute;
	return SCREE_OK;
}

static scree_status apply_surfaces(scree_world* world, const char* function, Own before, Own own)
{
	scree_attribute_def* cores = scree_allocate(sizeof *cores * (size_t)(own.collidables + 1));
	if (!cores)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d surfaces", function, own.collidables);
	for (int k = 0; k < own.collidables; ++k)
		if (memcmp(own.collidable + k, before.collidable + k, sizeof *own.collidable) != 0)
		{
			cores[k] = world->attributes[world->host_collidables[k].attribute];
			attribute_detach(world, world->host_collidables[k].attribute);
		}
	scree_status status = SCREE_OK;
	for (int k = 0; k < own.collidables && status == SCREE_OK; ++k)
		if (memcmp(own.collidable + k, before.collidable + k, sizeof *own.collidable) != 0)
			status = put_surface(world, function, k, own.collidable + k, cores + k);
	scree_release(cores);
	return status;
}

scree_status own_apply(scree_world* world, const char* function, Own before, Own own)
{
	for (int k = 0; k < own.bodies; ++k)
	{
		if (memcmp(&own.body[k].mass, &before.body[k].mass, sizeof own.body[k].mass) != 0)
		{
			TRY(edits_reserve(world, function, 0, 0, 2));
			world->own_masses = true;
			world->host_bodies[k].own_mass = own.body[k].mass;
			mass_set(world, k, mass_of_body(world, k));
		}
		if (own.body[k].disabled != before.body[k].disabled)
			TRY(scree_body_set_enabled(world, body_handle(world, k), !own.body[k].disabled));
	}
	for (int k = 0; k < own.joints; ++k)
		if ((own.joint[k] ^ before.joint[k]) & OWN_JOINT_DISABLED)
			TRY(scree_joint_set_enabled(world, joint_handle(world, k), !(own.joint[k] & OWN_JOINT_DISABLED)));
	return apply_surfaces(world, function, before, own);
}

scree_status own_chains_before(scree_world* world, Own own)
{
	static const int none = -1;
	for (int k = 0; k < own.joints; ++k)
	{
		HostJoint* host = world->host_joints + k;
		bool chained = own.joint[k] & OWN_JOINT_CHAINED;
		if (!slots_in_use(&world->joints, k) || chained == (host->spot >= 0))
			continue;
		host->spot = chained ? SPOT_UNKNOWN : -1; // the search compares only whether there is one
		world->chains_stale = true;
		TRY(world->backend->f->write(world->backend, POOL_joint_spot, k, 1, &none));
	}
	return SCREE_OK;
}
