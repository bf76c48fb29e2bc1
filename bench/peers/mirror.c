// SPDX-License-Identifier: MIT
// mirror.c -- builds a setup in an engine. Engines other than Scree get the bodies and joints of a Scree world.
//
// So all engines get the same numbers. The engine gets all changes in the order in which the setup makes them, because
// the results depend on that order.
#include "mirror.h"
#include "scene/churn.h"
#include "validate/scree_world.h"
#include <stdio.h>
#include <stdlib.h>

static bool create_body(const Mirror* mirror, scree_body handle)
{
	EngineBody body;
	bool good = read_body(mirror->world, handle, &body) && mirror->engine->create(mirror->state, &body, 1);
	free(body.parts);
	return good;
}

static bool destroy_body(const Mirror* mirror, int index) { return mirror->engine->destroy(mirror->state, &index, 1); }

static int index_of(scree_body body) { return scree_body_is_null(body) ? ENGINE_WORLD : (int)body.index; }

// Adds the new joints of the model to the engine. Joints that the model has lost need no call: the engine destroyed
// them with their bodies.
static bool add_joints(Mirror* mirror)
{
	int count, old = 0;
	scree_joint* joints = list_joints(mirror->world, &count);
	bool good = joints;
	for (int k = 0; good && k < count; ++k)
	{
		EngineJoint joint;
		while (old < mirror->joint_count && mirror->joints[old].index < joints[k].index)
			++old;
		if (old < mirror->joint_count && scree_joint_equals(mirror->joints[old], joints[k]))
			continue;
		good = report_status(scree_joint_get_def(mirror->world, joints[k], &joint.def));
		if (!good)
			break;
		joint.a = index_of(joint.def.body_a);
		joint.b = index_of(joint.def.body_b);
		good = mirror->engine->join(mirror->state, &joint);
	}
	free(mirror->joints);
	mirror->joints = joints;
	mirror->joint_count = count;
	return good;
}

// Replaces the list of bodies by the current bodies of the world.
static bool list(Mirror* mirror)
{
	free(mirror->bodies);
	free(mirror->indices);
	mirror->bodies = list_bodies(mirror->world, &mirror->count);
	mirror->indices = malloc(((size_t)mirror->count + 1) * sizeof(int));
	if (!mirror->indices)
		fprintf(stderr, "scree_peers: no memory for %d bodies\n", mirror->count);
	for (int k = 0; mirror->bodies && mirror->indices && k < mirror->count; ++k)
		mirror->indices[k] = (int)mirror->bodies[k].index;
	return mirror->bodies && mirror->indices;
}

// Destroys the bodies that the model no longer has, and adds its new bodies and joints.
static bool follow(Mirror* mirror)
{
	scree_body* before = mirror->bodies;
	int before_count = mirror->count, old = 0;
	mirror->bodies = NULL;
	bool good = list(mirror);
	for (int k = 0; good && k < mirror->count; ++k)
	{
		scree_body body = mirror->bodies[k];
		for (; old < before_count && before[old].index < body.index; ++old)
			destroy_body(mirror, (int)before[old].index);
		bool there = old < before_count && before[old].index == body.index;
		if (!there || !scree_body_equals(before[old], body))
			good = (!there || destroy_body(mirror, (int)body.index)) && create_body(mirror, body);
		old += there;
	}
	for (; good && old < before_count; ++old)
		destroy_body(mirror, (int)before[old].index);
	free(before);
	return good && add_joints(mirror);
}

static bool place_body(const Mirror* mirror, scree_body body)
{
	scree_pose pose;
	scree_velocity velocity;
	int index = (int)body.index;
	return report_status(scree_body_get_pose(mirror->world, body, &pose)) &&
	       report_status(scree_body_get_velocity(mirror->world, body, &velocity)) &&
	       mirror->engine->set_poses(mirror->state, &index, &pose, 1) &&
	       mirror->engine->set_velocity(mirror->state, index, velocity);
}

// Makes in the engine the changes of a scene from a file. Bodies that the scene replaces keep their places in the list,
// and their indices.
static bool follow_scene(Mirror* mirror, int64_t step)
{
	SceneChange* changes;
	int count = scene_changes(mirror->setup->scene, step, &changes);
	bool good = count >= 0 && list(mirror);
	for (int k = 0; good && k < count; ++k)
	{
		scree_body body = mirror->bodies[changes[k].item];
		if (changes[k].replaced)
			good = destroy_body(mirror, (int)body.index) && create_body(mirror, body);
		else
			good = place_body(mirror, body);
	}
	free(changes);
	return good;
}

bool mirror_change(Mirror* mirror, int64_t step)
{
	if (!setup_changes(mirror->setup))
		return true;
	if (!setup_change(mirror->setup, mirror->world, step))
		return false;
	if (mirror->engine->world)
		return list(mirror);
	return mirror->setup->scene ? follow_scene(mirror, step) : follow(mirror);
}

static bool build(Mirror* mirror)
{
	int detectors = 0;
	if (!report_status(scree_body_get_collidables(mirror->world, (scree_body){0}, NULL, 0, &detectors)))
		return false;
	if (detectors > 0)
	{
		fprintf(stderr, "scree_peers: %d collidables have no body: %s has no such thing\n", detectors,
		        mirror->engine->name);
		return false;
	}
	bool good = list(mirror);
	for (int k = 0; good && k < mirror->count; ++k)
		good = create_body(mirror, mirror->bodies[k]);
	return good && add_joints(mirror);
}

bool mirror_open(Mirror* mirror, const Setup* setup, const Engine* engine, const EngineOptions* options)
{
	EngineDef def = {.world = setup_world(setup)};
	*mirror = (Mirror){.setup = setup, .engine = engine, .state = engine->open(options, &def)};
	if (!mirror->state)
		return false;
	if (engine->world)
	{
		mirror->world = engine->world(mirror->state);
		return setup_fill(setup, mirror->world) && list(mirror);
	}
	mirror->world = setup_open(setup, 1);
	return mirror->world && build(mirror);
}

bool mirror_step(const Mirror* mirror)
{
	return mirror->engine->step(mirror->state, mirror->setup->dt, mirror->setup->substeps);
}

bool mirror_poses(const Mirror* mirror, scree_pose* poses)
{
	if (mirror->engine->world)
		return report_status(scree_bodies_get_poses(mirror->world, mirror->bodies, poses, mirror->count));
	return mirror->engine->read(mirror->state, mirror->indices, mirror->count, poses, NULL);
}

void mirror_close(Mirror* mirror)
{
	if (!mirror->state)
		return;
	if (!mirror->engine->world)
		scree_world_destroy(mirror->world);
	mirror->engine->close(mirror->state);
	free(mirror->bodies);
	free(mirror->indices);
	free(mirror->joints);
}
