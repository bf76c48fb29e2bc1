// SPDX-License-Identifier: MIT
// engine_box2d.c -- Box2D v3 as an engine to be measured, through its public interface.
//
// The scene is built into a Scree world first and read from there, bodies and joints, so that both engines get the same
// numbers.
// Contact stiffness and the like have each engine's defaults. Sleep is off, because Scree has none.
#include "engine_box2d.h"
#include "box2d_joint.h"
#include "box2d_shape.h"
#include "scene/churn.h"
#include "scree_world.h"
#include <stdlib.h>

typedef struct
{
	b2WorldId world;
	b2BodyId ground;  // what joints with the world hold on to; null before the first one
	b2BodyId* bodies; // in the order of the scene
	int count;
	const Setup* setup;
	scree_world* model; // never stepped: the bodies as the scene last placed them
	scree_body* parts;  // of the model
	scree_joint* joints;
	int joint_count;
} State;

static b2Vec2 vec(scree_vec v) { return (b2Vec2){v.x, v.y}; }

static bool add_collidable(const scree_world* model, scree_collidable collidable, b2BodyId body)
{
	scree_attribute attribute;
	scree_attribute_def surface;
	scree_pose pose;
	scree_filter filter;
	scree_shape shape;
	if (!report(scree_collidable_get_attribute(model, collidable, &attribute)) ||
	    !report(scree_attribute_get_def(model, attribute, &surface)) ||
	    !report(scree_collidable_get_local_pose(model, collidable, &pose)) ||
	    !report(scree_collidable_get_filter(model, collidable, &filter)) ||
	    !report(scree_shape_transform(&surface.shape, pose, &shape)))
		return false;
	return box2d_add_shape(body, &surface, &shape, filter);
}

static bool add_collidables(const scree_world* model, scree_body body, b2BodyId to)
{
	int count = 0;
	if (!report(scree_body_get_collidables(model, body, NULL, 0, &count)))
		return false;
	scree_collidable* collidables = malloc(((size_t)count + 1) * sizeof(scree_collidable));
	bool good = collidables && report(scree_body_get_collidables(model, body, collidables, count, &count));
	for (int k = 0; good && k < count; ++k)
		good = add_collidable(model, collidables[k], to);
	free(collidables);
	if (good)
		b2Body_ApplyMassFromShapes(to);
	return good;
}

static bool add_body(scree_world* model, scree_body body, b2WorldId world, b2BodyId* added)
{
	static const b2BodyType types[] = {[SCREE_BODY_STATIC] = b2_staticBody,
	                                   [SCREE_BODY_KINEMATIC] = b2_kinematicBody,
	                                   [SCREE_BODY_DYNAMIC] = b2_dynamicBody};
	scree_body_type type;
	scree_pose pose;
	scree_velocity velocity;
	uint32_t locks;
	b2BodyDef def = b2DefaultBodyDef();
	if (!report(scree_body_get_type(model, body, &type)) || !report(scree_body_get_pose(model, body, &pose)) ||
	    !report(scree_body_get_velocity(model, body, &velocity)) ||
	    !report(scree_body_get_damping(model, body, &def.linearDamping, &def.angularDamping)) ||
	    !report(scree_body_get_gravity_scale(model, body, &def.gravityScale)) ||
	    !report(scree_body_get_locks(model, body, &locks)))
		return false;

	def.type = types[type];
	def.position = (b2Pos){pose.position.x, pose.position.y};
	def.rotation = (b2Rot){pose.rotation.c, pose.rotation.s};
	def.linearVelocity = vec(velocity.linear);
	def.angularVelocity = velocity.angular;
	def.motionLocks = (b2MotionLocks){locks & SCREE_LOCK_X, locks & SCREE_LOCK_Y, locks & SCREE_LOCK_ROTATION};
	*added = b2CreateBody(world, &def);
	if (!add_collidables(model, body, *added))
		return false;
	// the velocity is that of the center of mass, which Box2D knows only now
	b2Body_SetLinearVelocity(*added, def.linearVelocity);
	return true;
}

// The body of Box2D for one of the model, which are listed by rising index.
static b2BodyId find_body(State* state, scree_body body)
{
	b2BodyDef ground = b2DefaultBodyDef();
	if (scree_body_is_null(body) && B2_IS_NULL(state->ground))
		state->ground = b2CreateBody(state->world, &ground);
	if (scree_body_is_null(body))
		return state->ground;
	int low = 0;
	for (int high = state->count; low < high;)
	{
		int middle = low + (high - low) / 2;
		if (state->parts[middle].index < body.index)
			low = middle + 1;
		else
			high = middle;
	}
	return state->bodies[low];
}

// Adds the joints of the model that were not there before. Those that are gone went with their bodies.
static bool add_joints(State* state)
{
	int count, old = 0;
	scree_joint* joints = list_joints(state->model, &count);
	bool good = joints;
	for (int k = 0; good && k < count; ++k)
	{
		scree_joint_def def;
		while (old < state->joint_count && state->joints[old].index < joints[k].index)
			++old;
		if (old < state->joint_count && scree_joint_equals(state->joints[old], joints[k]))
			continue;
		good = report(scree_joint_get_def(state->model, joints[k], &def)) &&
		       box2d_add_joint(state->world, &def, find_body(state, def.body_a), find_body(state, def.body_b));
	}
	free(state->joints);
	state->joints = joints;
	state->joint_count = count;
	return good;
}

// Destroys the bodies that the model no longer has, and adds those that are new.
static bool follow(State* state)
{
	int count, old = 0;
	scree_body* parts = list_bodies(state->model, &count);
	b2BodyId* bodies = calloc((size_t)count + 1, sizeof(b2BodyId));
	bool good = parts && bodies;
	for (int k = 0; good && k < count; ++k)
	{
		for (; old < state->count && state->parts[old].index < parts[k].index; ++old)
			b2DestroyBody(state->bodies[old]);
		bool there = old < state->count && state->parts[old].index == parts[k].index;
		if (there && scree_body_equals(state->parts[old], parts[k]))
			bodies[k] = state->bodies[old];
		else
		{
			if (there)
				b2DestroyBody(state->bodies[old]);
			good = add_body(state->model, parts[k], state->world, &bodies[k]);
		}
		old += there;
	}
	for (; good && old < state->count; ++old)
		b2DestroyBody(state->bodies[old]);
	free(state->parts);
	free(state->bodies);
	state->parts = parts;
	state->bodies = bodies;
	state->count = count;
	return good && add_joints(state);
}

static bool build(scree_world* model, State* state)
{
	int detectors = 0;
	if (!report(scree_body_get_collidables(model, (scree_body){0}, NULL, 0, &detectors)))
		return false;
	if (detectors > 0)
	{
		fprintf(stderr, "scree_peers: %d collidables have no body: Box2D knows no such thing\n", detectors);
		return false;
	}
	state->parts = list_bodies(model, &state->count);
	state->bodies = calloc((size_t)state->count + 1, sizeof(b2BodyId));
	bool good = state->parts && state->bodies;
	for (int k = 0; good && k < state->count; ++k)
		good = add_body(model, state->parts[k], state->world, &state->bodies[k]);
	return good && add_joints(state);
}

static bool place_body(scree_world* model, scree_body body, b2BodyId placed)
{
	scree_pose pose;
	scree_velocity velocity;
	if (!report(scree_body_get_pose(model, body, &pose)) || !report(scree_body_get_velocity(model, body, &velocity)))
		return false;
	b2Body_SetTransform(placed, (b2Pos){pose.position.x, pose.position.y}, (b2Rot){pose.rotation.c, pose.rotation.s});
	b2Body_SetLinearVelocity(placed, vec(velocity.linear));
	b2Body_SetAngularVelocity(placed, velocity.angular);
	return true;
}

// Changes the model first, then the bodies of Box2D after it.
static bool change(void* context, int64_t step)
{
	State* state = context;
	const Scene* scene = state->setup->scene;
	if (!scene)
		return !state->setup->rig->change || (setup_change(state->setup, state->model, step) && follow(state));
	if (!scene_churns(scene))
		return true;
	SceneChange* changes;
	int count = scene_changes(scene, step, &changes), bodies;
	bool good = count >= 0 && report(scene_churn(scene, state->model, step)) &&
	            report(scree_world_get_bodies(state->model, state->parts, state->count, &bodies));
	for (int k = 0; good && k < count; ++k)
	{
		int item = changes[k].item;
		if (changes[k].replaced)
		{
			b2DestroyBody(state->bodies[item]);
			good = add_body(state->model, state->parts[item], state->world, &state->bodies[item]);
		}
		else
			good = place_body(state->model, state->parts[item], state->bodies[item]);
	}
	free(changes);
	return good;
}

static void close(void* context)
{
	State* state = context;
	if (b2World_IsValid(state->world))
		b2DestroyWorld(state->world);
	scree_world_destroy(state->model);
	free(state->bodies);
	free(state->parts);
	free(state->joints);
	free(state);
}

static void* open(const Setup* setup, const EngineOptions* options)
{
	State* state = calloc(1, sizeof(State));
	scree_world* model = state ? setup_open(setup, "cpu", 1) : NULL;
	if (!model)
	{
		free(state);
		return NULL;
	}
	b2WorldDef def = b2DefaultWorldDef();
	scree_vec gravity = {0};
	scree_world_get_gravity(model, &gravity);
	def.gravity = vec(gravity);
	def.enableSleep = false;
	def.enableContinuous = options->continuous;
	def.workerCount = options->threads;
	state->world = b2CreateWorld(&def);
	state->setup = setup;
	state->model = model;
	if (build(model, state))
		return state;
	close(state);
	return NULL;
}

static bool step(void* context, float dt, int substeps)
{
	const State* state = context;
	b2World_Step(state->world, dt, substeps);
	return true;
}

static bool wait(void* context)
{
	(void)context; // a step returns when all work is done
	return true;
}

static bool poses(void* context, scree_pose* poses, int count)
{
	const State* state = context;
	for (int k = 0; k < count; ++k)
	{
		b2Pos position = b2Body_GetPosition(state->bodies[k]);
		b2Rot rotation = b2Body_GetRotation(state->bodies[k]);
		poses[k] = (scree_pose){{(float)position.x, (float)position.y}, {rotation.c, rotation.s}};
	}
	return true;
}

static bool hash(void* context, uint64_t* hash)
{
	const State* state = context;
	*hash = b2World_GetStateHash(state->world);
	return true;
}

const Engine box2d_engine = {"box2d", open, change, step, wait, poses, hash, close};
