// SPDX-License-Identifier: MIT
// lab_scree.c -- Scree as the engine of a lab.
#include "lab_scree.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct // of a body's first collidable
{
	scree_attribute attribute;
	scree_filter filter;
} First;

typedef struct
{
	scree_world* world;
	scree_body* bodies; // by their index in the lab
	First* firsts;
	int count;
	scree_body* some;     // handles of a batch
	scree_body_def* defs; // of a batch
	int room;
} State;

static bool report(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "scree validate: %s\n", scree_error());
	return status == SCREE_OK;
}

scree_world_def scree_lab_world_def(const LabOptions* options)
{
	scree_world_def def = scree_world_def_default();
	def.device = options->device;
	def.threads = options->threads;
	def.lanes = options->lanes;
	def.allow_unequal_bits = options->allow_unequal_bits;
	return def;
}

static void* open(const LabOptions* options, const LabDef* lab)
{
	State* state = calloc(1, sizeof(State));
	if (!state)
		return NULL;
	scree_world_def def = scree_lab_world_def(options);
	def.gravity = lab->gravity;
	def.max_speed = lab->max_speed;
	if (lab->contact_hertz > 0.0f)
		def.contact_hertz = lab->contact_hertz;
	if (report(scree_world_create(&def, &state->world)))
		return state;
	free(state);
	return NULL;
}

static void close(void* context)
{
	State* state = context;
	scree_world_destroy(state->world);
	free(state->bodies);
	free(state->firsts);
	free(state->some);
	free(state->defs);
	free(state);
}

// Allocates handles and definitions for a batch.
static bool reserve(State* state, int count)
{
	if (count <= state->room)
		return true;
	scree_body* some = realloc(state->some, (size_t)count * sizeof *some);
	state->some = some ? some : state->some;
	scree_body_def* defs = realloc(state->defs, (size_t)count * sizeof *defs);
	state->defs = defs ? defs : state->defs;
	if (some && defs)
		state->room = count;
	return some && defs;
}

static bool gather(State* state, const int* bodies, int count)
{
	if (!reserve(state, count))
		return false;
	for (int k = 0; k < count; ++k)
		state->some[k] = state->bodies[bodies[k]];
	return true;
}

// Creates the other collidables of a body. They move its center of mass, so that its velocity is set again.
static bool add_others(State* state, const Lab* lab, int index)
{
	const LabBody* body = &lab->bodies[index];
	for (int k = 1; k < body->count; ++k)
	{
		const LabPart* part = &lab->parts[body->first + k];
		scree_collidable_def def = scree_collidable_def_default();
		def.body = state->bodies[index];
		def.filter = part->filter;
		if (!report(scree_attribute_create(state->world, &part->surface, &def.attribute)) ||
		    !report(scree_collidable_create(state->world, &def, NULL)))
			return false;
	}
	return body->count < 2 || report(scree_body_set_velocity(state->world, state->bodies[index], body->def.velocity));
}

// Finds the attributes of new bodies from first on. Consecutive equal attributes are looked up once.
static bool find_firsts(State* state, const Lab* lab, int first, int count)
{
	const LabPart* last = NULL;
	scree_attribute attribute = {0};
	for (int k = first; k < first + count; ++k)
	{
		const LabPart* part = &lab->parts[lab->bodies[k].first];
		if (lab->bodies[k].count == 0)
			continue;
		bool same = last && memcmp(&part->surface, &last->surface, sizeof part->surface) == 0;
		if (!same && !report(scree_attribute_create(state->world, &part->surface, &attribute)))
			return false;
		last = part;
		state->firsts[k] = (First){attribute, part->filter};
	}
	return true;
}

// Creates these bodies in one batch; if bodies is null, those from first on.
static bool create_some(State* state, const Lab* lab, const int* bodies, int first, int count)
{
	if (!reserve(state, count))
		return false;
	for (int k = 0; k < count; ++k)
	{
		int index = bodies ? bodies[k] : first + k;
		const LabBody* body = &lab->bodies[index];
		state->defs[k] = body->def;
		if (body->count == 0)
			continue;
		state->defs[k].attribute = state->firsts[index].attribute;
		state->defs[k].filter = state->firsts[index].filter;
	}
	if (!report(scree_bodies_create(state->world, state->defs, count, state->some)))
		return false;
	for (int k = 0; k < count; ++k)
	{
		int index = bodies ? bodies[k] : first + k;
		state->bodies[index] = state->some[k];
		if (!add_others(state, lab, index))
			return false;
	}
	return true;
}

static bool create(void* context, const Lab* lab, int first, int count)
{
	State* state = context;
	scree_body* bodies = realloc(state->bodies, (size_t)(first + count) * sizeof *bodies);
	if (!bodies)
		return false;
	state->bodies = bodies;
	First* firsts = realloc(state->firsts, (size_t)(first + count) * sizeof *firsts);
	if (!firsts)
		return false;
	state->firsts = firsts;
	state->count = first + count;
	return find_firsts(state, lab, first, count) && create_some(state, lab, NULL, first, count);
}

static bool join(void* context, const LabJoint* joint)
{
	State* state = context;
	scree_joint_def def = joint->def;
	scree_joint created;
	def.body_a = state->bodies[joint->a];
	def.body_b = state->bodies[joint->b];
	return report(scree_joint_create(state->world, &def, &created));
}

static bool replace(void* context, const Lab* lab, const int* bodies, int count)
{
	State* state = context;
	return gather(state, bodies, count) && report(scree_bodies_destroy(state->world, state->some, count)) &&
	       create_some(state, lab, bodies, 0, count);
}

static bool set_poses(void* context, const int* bodies, const scree_pose* poses, int count)
{
	State* state = context;
	return gather(state, bodies, count) && report(scree_bodies_set_poses(state->world, state->some, poses, count));
}

static bool set_velocity(void* context, int body, scree_velocity velocity)
{
	State* state = context;
	return report(scree_body_set_velocity(state->world, state->bodies[body], velocity));
}

static bool push(void* context, int body, scree_vec force)
{
	State* state = context;
	return report(scree_body_apply_force(state->world, state->bodies[body], force));
}

static bool step(void* context, float dt, int substeps, int* frozen)
{
	State* state = context;
	scree_counters counters;
	if (!report(scree_world_step(state->world, dt, substeps)) ||
	    !report(scree_world_get_counters(state->world, &counters)))
		return false;
	*frozen += counters.frozen_bodies;
	return true;
}

static bool read(void* context, scree_pose* poses, scree_velocity* velocities)
{
	State* state = context;
	return report(scree_bodies_get_poses(state->world, state->bodies, poses, state->count)) &&
	       report(scree_bodies_get_velocities(state->world, state->bodies, velocities, state->count));
}

static bool wait(void* context)
{
	State* state = context;
	return report(scree_world_wait(state->world));
}

static bool hash(void* context, uint64_t* hash)
{
	State* state = context;
	return report(scree_world_get_hash(state->world, hash));
}

static double bytes(void* context)
{
	State* state = context;
	scree_counters counters;
	return report(scree_world_get_counters(state->world, &counters)) ? (double)counters.device_bytes : 0.0;
}

int scree_lab_touches(void* context, int body)
{
	State* state = context;
	scree_contact contacts[64];
	int count = 0, overlaps = 0;
	if (!report(scree_body_get_contacts(state->world, state->bodies[body], contacts, 64, &count)))
		return 0;
	for (int k = 0; k < count && k < 64; ++k)
		overlaps += contacts[k].points[0].separation < 0.0f ||
		            (contacts[k].count > 1 && contacts[k].points[1].separation < 0.0f);
	return overlaps;
}

bool scree_lab_counters(void* context, scree_counters* counters)
{
	State* state = context;
	return report(scree_world_get_counters(state->world, counters));
}

const LabEngine scree_lab = {"scree", open, create, join, replace, set_poses, set_velocity,
                             push,    step, read,   wait, hash,    bytes,     close};
