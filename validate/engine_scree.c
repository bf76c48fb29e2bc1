// SPDX-License-Identifier: MIT
// engine_scree.c -- implements the functions of engine.h with Scree.
#include "engine_scree.h"
#include "scree_world.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct
{
	scree_world* world;
	scree_body* bodies; // handle of each body, by the index of the body
	int room;
	scree_body* some;     // handles of the bodies of a call
	scree_body_def* defs; // definitions of the bodies of a call
	int batch_room;
} State;

void engine_set_device(scree_world_def* def, const EngineOptions* options)
{
	def->device = options->device;
	def->threads = options->threads;
	def->lanes = options->lanes;
	def->allow_unequal_bits = options->allow_unequal_bits;
}

static bool report_memory(bool good)
{
	if (!good)
		fprintf(stderr, "scree: out of memory\n");
	return good;
}

static void* open(const EngineOptions* options, const EngineDef* def)
{
	State* state = calloc(1, sizeof(State));
	if (!report_memory(state))
		return NULL;
	scree_world_def world = def->world;
	engine_set_device(&world, options);
	world.sleep = options->sleep;
	if (def->max_speed > 0.0f)
		world.max_speed = def->max_speed;
	if (def->contact_hertz > 0.0f)
		world.contact_hertz = def->contact_hertz;
	if (report_status(scree_world_create(&world, &state->world)))
		return state;
	free(state);
	return NULL;
}

static void close(void* context)
{
	State* state = context;
	scree_world_destroy(state->world);
	free(state->bodies);
	free(state->some);
	free(state->defs);
	free(state);
}

// Allocates handles and definitions for `count` bodies of a call.
static bool reserve(State* state, int count)
{
	if (count <= state->batch_room)
		return true;
	free(state->some);
	free(state->defs);
	state->some = malloc((size_t)count * sizeof *state->some);
	state->defs = malloc((size_t)count * sizeof *state->defs);
	state->batch_room = state->some && state->defs ? count : 0;
	return report_memory(state->batch_room > 0);
}

// Makes room in state->bodies for the highest index of these bodies.
static bool grow(State* state, const EngineBody* bodies, int count)
{
	int highest = -1;
	for (int k = 0; k < count; ++k)
		highest = bodies[k].index > highest ? bodies[k].index : highest;
	if (highest < state->room)
		return true;
	int room = 2 * highest + 1;
	scree_body* handles = realloc(state->bodies, (size_t)room * sizeof *handles);
	if (!report_memory(handles))
		return false;
	state->bodies = handles;
	state->room = room;
	return true;
}

static bool gather(State* state, const int* bodies, int count)
{
	if (!reserve(state, count))
		return false;
	for (int k = 0; k < count; ++k)
		state->some[k] = state->bodies[bodies[k]];
	return true;
}

// Fills the definitions of the bodies of a call. Successive bodies with equal surfaces share one lookup of the
// attribute.
static bool define(State* state, const EngineBody* bodies, int count)
{
	const EnginePart* last = NULL;
	scree_attribute attribute = {0};
	for (int k = 0; k < count; ++k)
	{
		const EnginePart* part = bodies[k].parts;
		state->defs[k] = bodies[k].def;
		if (bodies[k].count == 0)
			continue;
		bool same = last && memcmp(&part->surface, &last->surface, sizeof part->surface) == 0;
		if (!same && !report_status(scree_attribute_create(state->world, &part->surface, &attribute)))
			return false;
		last = part;
		state->defs[k].attribute = attribute;
		state->defs[k].filter = part->filter;
	}
	return true;
}

// Creates all collidables of a body except the first. They move the center of mass, so the velocity of the body is set
// again.
static bool add_others(State* state, const EngineBody* body)
{
	for (int k = 1; k < body->count; ++k)
	{
		const EnginePart* part = &body->parts[k];
		scree_collidable_def def = scree_collidable_def_default();
		def.body = state->bodies[body->index];
		def.filter = part->filter;
		if (!report_status(scree_attribute_create(state->world, &part->surface, &def.attribute)) ||
		    !report_status(scree_collidable_create(state->world, &def, NULL)))
			return false;
	}
	return body->count < 2 ||
	       report_status(scree_body_set_velocity(state->world, state->bodies[body->index], body->def.velocity));
}

static bool create(void* context, const EngineBody* bodies, int count)
{
	State* state = context;
	if (!reserve(state, count) || !grow(state, bodies, count) || !define(state, bodies, count) ||
	    !report_status(scree_bodies_create(state->world, state->defs, count, state->some)))
		return false;
	for (int k = 0; k < count; ++k)
	{
		state->bodies[bodies[k].index] = state->some[k];
		if (!add_others(state, &bodies[k]))
			return false;
	}
	return true;
}

static bool destroy(void* context, const int* bodies, int count)
{
	State* state = context;
	return gather(state, bodies, count) && report_status(scree_bodies_destroy(state->world, state->some, count));
}

static bool join(void* context, const EngineJoint* joint)
{
	State* state = context;
	scree_joint_def def = joint->def;
	def.body_a = joint->a == ENGINE_WORLD ? SCREE_NULL_BODY : state->bodies[joint->a];
	def.body_b = joint->b == ENGINE_WORLD ? SCREE_NULL_BODY : state->bodies[joint->b];
	return report_status(scree_joint_create(state->world, &def, NULL));
}

static bool set_poses(void* context, const int* bodies, const scree_pose* poses, int count)
{
	State* state = context;
	return gather(state, bodies, count) &&
	       report_status(scree_bodies_set_poses(state->world, state->some, poses, count));
}

static bool set_velocity(void* context, int body, scree_velocity velocity)
{
	State* state = context;
	return report_status(scree_body_set_velocity(state->world, state->bodies[body], velocity));
}

static bool push(void* context, int body, scree_vec force)
{
	State* state = context;
	return report_status(scree_body_apply_force(state->world, state->bodies[body], force));
}

static bool step(void* context, float dt, int substeps)
{
	State* state = context;
	return report_status(scree_world_step(state->world, dt, substeps));
}

static bool wait(void* context)
{
	State* state = context;
	return report_status(scree_world_wait(state->world));
}

static bool frozen(void* context, int* frozen)
{
	State* state = context;
	scree_counters counters;
	if (!report_status(scree_world_get_counters(state->world, &counters)))
		return false;
	*frozen += counters.frozen_bodies;
	return true;
}

static bool awake(void* context, int* awake)
{
	State* state = context;
	scree_counters counters;
	bool good = report_status(scree_world_get_counters(state->world, &counters));
	*awake = good ? counters.dynamic_bodies - counters.asleep_bodies : 0;
	return good;
}

static bool read(void* context, const int* bodies, int count, scree_pose* poses, scree_velocity* velocities)
{
	State* state = context;
	if (bodies && !gather(state, bodies, count))
		return false;
	const scree_body* handles = bodies ? state->some : state->bodies;
	return report_status(scree_bodies_get_poses(state->world, handles, poses, count)) &&
	       (!velocities || report_status(scree_bodies_get_velocities(state->world, handles, velocities, count)));
}

static bool hash(void* context, uint64_t* hash)
{
	State* state = context;
	return report_status(scree_world_get_hash(state->world, hash));
}

static double bytes(void* context)
{
	State* state = context;
	scree_counters counters;
	return report_status(scree_world_get_counters(state->world, &counters)) ? (double)counters.device_bytes : 0.0;
}

static scree_world* world(void* context)
{
	State* state = context;
	return state->world;
}

int engine_overlaps(void* context, int body)
{
	State* state = context;
	scree_contact contacts[64];
	int count = 0, overlaps = 0;
	if (!report_status(scree_body_get_contacts(state->world, state->bodies[body], contacts, 64, &count)))
		return 0;
	for (int k = 0; k < count && k < 64; ++k)
		overlaps += contacts[k].points[0].separation < 0.0f ||
		            (contacts[k].count > 1 && contacts[k].points[1].separation < 0.0f);
	return overlaps;
}

const Engine scree_engine = {"scree", open,   create, destroy, join, set_poses, set_velocity, push, step,
                             wait,    frozen, awake,  read,    hash, bytes,     world,        close};
