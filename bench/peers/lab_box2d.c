// SPDX-License-Identifier: MIT
// lab_box2d.c -- Box2D v3 as the engine of a lab: its defaults, with continuous collision, without sleep.
#include "lab_box2d.h"
#include "box2d_joint.h"
#include "box2d_shape.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct
{
	b2WorldId world;
	b2BodyId* bodies; // by their index in the lab
	int count;
} State;

static b2Vec2 vec(scree_vec v) { return (b2Vec2){v.x, v.y}; }

// Logs go to standard error, because rows of results go to standard output.
static void print_log(const char* message) { fprintf(stderr, "Box2D: %s\n", message); }

static void* open(const LabOptions* options, const LabDef* lab)
{
	State* state = calloc(1, sizeof(State));
	if (!state)
		return NULL;
	b2SetLogFcn(print_log);
	b2WorldDef def = b2DefaultWorldDef();
	def.gravity = vec(lab->gravity);
	def.maximumLinearSpeed = lab->max_speed;
	if (lab->contact_hertz > 0.0f)
		def.contactHertz = lab->contact_hertz;
	def.enableSleep = false;
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

static bool create_one(State* state, const Lab* lab, int index)
{
	static const b2BodyType types[] = {[SCREE_BODY_STATIC] = b2_staticBody,
	                                   [SCREE_BODY_KINEMATIC] = b2_kinematicBody,
	                                   [SCREE_BODY_DYNAMIC] = b2_dynamicBody};
	const LabBody* body = &lab->bodies[index];
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
	def.isBullet = lab->def.bullets && body->thrown;
	def.motionLocks =
	    (b2MotionLocks){from->locks & SCREE_LOCK_X, from->locks & SCREE_LOCK_Y, from->locks & SCREE_LOCK_ROTATION};
	state->bodies[index] = b2CreateBody(state->world, &def);
	for (int k = 0; k < body->count; ++k)
	{
		const LabPart* part = &lab->parts[body->first + k];
		if (!box2d_add_shape(state->bodies[index], &part->surface, &part->surface.shape, part->filter))
			return false;
	}
	b2Body_ApplyMassFromShapes(state->bodies[index]);
	// the velocity is that of the center of mass, which Box2D knows only now
	b2Body_SetLinearVelocity(state->bodies[index], def.linearVelocity);
	return true;
}

static bool create(void* context, const Lab* lab, int first, int count)
{
	State* state = context;
	b2BodyId* bodies = realloc(state->bodies, (size_t)(first + count) * sizeof *bodies);
	if (!bodies)
		return false;
	state->bodies = bodies;
	state->count = first + count;
	for (int k = first; k < first + count; ++k)
	{
		if (!create_one(state, lab, k))
			return false;
	}
	return true;
}

static bool join(void* context, const LabJoint* joint)
{
	State* state = context;
	return box2d_add_joint(state->world, &joint->def, state->bodies[joint->a], state->bodies[joint->b]);
}

static bool replace(void* context, const Lab* lab, const int* bodies, int count)
{
	State* state = context;
	for (int k = 0; k < count; ++k)
		b2DestroyBody(state->bodies[bodies[k]]);
	for (int k = 0; k < count; ++k)
	{
		if (!create_one(state, lab, bodies[k]))
			return false;
	}
	return true;
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

// Box2D freezes no bodies.
static bool step(void* context, float dt, int substeps, int* frozen)
{
	State* state = context;
	(void)frozen;
	b2World_Step(state->world, dt, substeps);
	return true;
}

static bool read(void* context, scree_pose* poses, scree_velocity* velocities)
{
	State* state = context;
	for (int k = 0; k < state->count; ++k)
	{
		b2Pos p = b2Body_GetPosition(state->bodies[k]);
		b2Rot q = b2Body_GetRotation(state->bodies[k]);
		b2Vec2 v = b2Body_GetLinearVelocity(state->bodies[k]);
		poses[k] = (scree_pose){{(float)p.x, (float)p.y}, {q.c, q.s}};
		velocities[k] = (scree_velocity){{v.x, v.y}, b2Body_GetAngularVelocity(state->bodies[k])};
	}
	return true;
}

static bool wait(void* context)
{
	(void)context; // a step returns when all work is done
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

const LabEngine box2d_lab = {"box2d", open, create, join, replace, set_poses, set_velocity,
                             push,    step, read,   wait, hash,    bytes,     close};
