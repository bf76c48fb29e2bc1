// SPDX-License-Identifier: MIT
// engine_box2d.c -- implements the functions of Engine with the public interface of Box2D v3.
//
// Solver parameters, such as the contact stiffness, have each engine's default values.
#include "engine_box2d.h"
#include "box2d_joint.h"
#include "box2d_shape.h"
#include <stdio.h>
#include <stdlib.h>

typedef struct
{
	b2WorldId world;
	b2BodyId ground;  // body to which joints with the world are attached; null before the first such joint
	b2BodyId* bodies; // bodies of Box2D, by EngineBody.index
	int room;         // number of allocated entries of `bodies`
} State;

static b2Vec2 vec(scree_vec v) { return (b2Vec2){v.x, v.y}; }

// Logs go to standard error, because rows of results go to standard output.
static void print_log(const char* message) { fprintf(stderr, "Box2D: %s\n", message); }

static void* open(const EngineOptions* options, const EngineDef* engine)
{
	State* state = calloc(1, sizeof(State));
	if (!state)
	{
		fprintf(stderr, "Box2D: out of memory\n");
		return NULL;
	}
	b2SetLogFcn(print_log);
	b2WorldDef def = b2DefaultWorldDef();
	def.gravity = vec(engine->world.gravity);
	if (engine->max_speed > 0.0f)
		def.maximumLinearSpeed = engine->max_speed;
	if (engine->contact_hertz > 0.0f)
		def.contactHertz = engine->contact_hertz;
	def.enableSleep = options->sleep;
	def.enableContinuous = options->continuous;
	def.workerCount = options->threads > 0 ? options->threads : 1;
	state->world = b2CreateWorld(&def);
	return state;
}

static void close(void* context)
{
	State* state = context;
	b2DestroyWorld(state->world);
	free(state->bodies);
	free(state);
}

static bool create_one(State* state, const EngineBody* body)
{
	static const b2BodyType types[] = {[SCREE_BODY_STATIC] = b2_staticBody,
	                                   [SCREE_BODY_KINEMATIC] = b2_kinematicBody,
	                                   [SCREE_BODY_DYNAMIC] = b2_dynamicBody};
	const scree_body_def* from = &body->def;
	b2BodyDef def = b2DefaultBodyDef();
	def.type = types[from->type];
	def.position = (b2Pos){from->pose.position.x, from->pose.position.y};
	def.rotation = (b2Rot){from->pose.rotation.c, from->pose.rotation.s};
	def.linearVelocity = vec(from->velocity.linear);
	def.angularVelocity = from->velocity.angular;
	def.linearDamping = from->linear_damping;
	def.angularDamping = from->angular_damping;
	def.gravityScale = from->gravity_scale;
	def.isBullet = body->bullet;
	def.motionLocks =
	    (b2MotionLocks){from->locks & SCREE_LOCK_X, from->locks & SCREE_LOCK_Y, from->locks & SCREE_LOCK_ROTATION};
	b2BodyId created = state->bodies[body->index] = b2CreateBody(state->world, &def);
	for (int k = 0; k < body->count; ++k)
	{
		const EnginePart* part = &body->parts[k];
		if (!box2d_add_shape(created, &part->surface, &part->surface.shape, part->filter))
			return false;
	}
	b2Body_ApplyMassFromShapes(created);
	// sets the velocity of the center of mass again, because Box2D computes that center only in
	// b2Body_ApplyMassFromShapes
	b2Body_SetLinearVelocity(created, def.linearVelocity);
	return true;
}

// Allocates memory for bodies with indices from 0 to index. Returns false after printing a sentence.
static bool grow(State* state, int index)
{
	if (index < state->room)
		return true;
	int room = 2 * index + 1;
	b2BodyId* bodies = realloc(state->bodies, (size_t)room * sizeof *bodies);
	if (!bodies)
	{
		fprintf(stderr, "Box2D: out of memory\n");
		return false;
	}
	state->bodies = bodies;
	state->room = room;
	return true;
}

static bool create(void* context, const EngineBody* bodies, int count)
{
	State* state = context;
	for (int k = 0; k < count; ++k)
	{
		if (!grow(state, bodies[k].index) || !create_one(state, &bodies[k]))
			return false;
	}
	return true;
}

static bool destroy(void* context, const int* bodies, int count)
{
	State* state = context;
	for (int k = 0; k < count; ++k)
		b2DestroyBody(state->bodies[bodies[k]]);
	return true;
}

static b2BodyId find_body(State* state, int index)
{
	b2BodyDef ground = b2DefaultBodyDef();
	if (index != ENGINE_WORLD)
		return state->bodies[index];
	if (B2_IS_NULL(state->ground))
		state->ground = b2CreateBody(state->world, &ground);
	return state->ground;
}

static bool join(void* context, const EngineJoint* joint)
{
	State* state = context;
	return box2d_add_joint(state->world, &joint->def, find_body(state, joint->a), find_body(state, joint->b));
}

static bool set_poses(void* context, const int* bodies, const scree_pose* poses, int count)
{
	State* state = context;
	for (int k = 0; k < count; ++k)
		b2Body_SetTransform(state->bodies[bodies[k]], (b2Pos){poses[k].position.x, poses[k].position.y},
		                    (b2Rot){poses[k].rotation.c, poses[k].rotation.s});
	return true;
}

static bool set_velocity(void* context, int body, scree_velocity velocity)
{
	State* state = context;
	b2Body_SetLinearVelocity(state->bodies[body], vec(velocity.linear));
	b2Body_SetAngularVelocity(state->bodies[body], velocity.angular);
	return true;
}

static bool push(void* context, int body, scree_vec force)
{
	State* state = context;
	b2Body_ApplyForceToCenter(state->bodies[body], vec(force), true);
	return true;
}

static bool step(void* context, float dt, int substeps)
{
	State* state = context;
	b2World_Step(state->world, dt, substeps);
	return true;
}

static bool wait(void* context)
{
	(void)context; // nothing to wait for: a step of Box2D returns when all work is done
	return true;
}

static bool frozen(void* context, int* frozen)
{
	(void)context;
	(void)frozen; // Box2D freezes no bodies
	return true;
}

static bool awake(void* context, int* awake)
{
	State* state = context;
	*awake = 0;
	for (int k = 0; k < state->room; ++k)
		*awake += b2Body_IsValid(state->bodies[k]) && b2Body_GetType(state->bodies[k]) == b2_dynamicBody &&
		          b2Body_IsAwake(state->bodies[k]);
	return true;
}

static bool read(void* context, const int* bodies, int count, scree_pose* poses, scree_velocity* velocities)
{
	State* state = context;
	for (int k = 0; k < count; ++k)
	{
		b2BodyId body = state->bodies[bodies ? bodies[k] : k];
		b2Pos p = b2Body_GetPosition(body);
		b2Rot q = b2Body_GetRotation(body);
		poses[k] = (scree_pose){{(float)p.x, (float)p.y}, {q.c, q.s}};
		if (!velocities)
			continue;
		b2Vec2 v = b2Body_GetLinearVelocity(body);
		velocities[k] = (scree_velocity){{v.x, v.y}, b2Body_GetAngularVelocity(body)};
	}
	return true;
}

static bool hash(void* context, uint64_t* hash)
{
	State* state = context;
	*hash = b2World_GetStateHash(state->world);
	return true;
}

static double bytes(void* context)
{
	State* state = context;
	return (double)b2World_GetCounters(state->world).byteCount;
}

b2WorldId box2d_world(void* context)
{
	State* state = context;
	return state->world;
}

const Engine box2d_engine = {"box2d", open,   create, destroy, join, set_poses, set_velocity, push, step,
                             wait,    frozen, awake,  read,    hash, bytes,     NULL,         close};
