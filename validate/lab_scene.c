// SPDX-License-Identifier: MIT
// lab_scene.c -- a scene file as a lab: built into a Scree world, and read back from there body by body.
#include "lab_scene.h"
#include "experiment_support.h"
#include "scene/build.h"
#include "scene/find.h"
#include "scene/load.h"
#include <stdlib.h>

static bool report(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "scree validate: %s\n", scree_error());
	return status == SCREE_OK;
}

static bool read_part(const scree_world* model, scree_collidable collidable, LabPart* part)
{
	scree_attribute attribute;
	scree_pose pose;
	scree_shape shape;
	if (!report(scree_collidable_get_attribute(model, collidable, &attribute)) ||
	    !report(scree_attribute_get_def(model, attribute, &part->surface)) ||
	    !report(scree_collidable_get_local_pose(model, collidable, &pose)) ||
	    !report(scree_collidable_get_filter(model, collidable, &part->filter)) ||
	    !report(scree_shape_transform(&part->surface.shape, pose, &shape)))
		return false;
	part->surface.shape = shape;
	return true;
}

static bool read_def(scree_world* model, scree_body body, scree_body_def* def)
{
	*def = scree_body_def_default();
	return report(scree_body_get_type(model, body, &def->type)) &&
	       report(scree_body_get_pose(model, body, &def->pose)) &&
	       report(scree_body_get_velocity(model, body, &def->velocity)) &&
	       report(scree_body_get_damping(model, body, &def->linear_damping, &def->angular_damping)) &&
	       report(scree_body_get_gravity_scale(model, body, &def->gravity_scale)) &&
	       report(scree_body_get_locks(model, body, &def->locks));
}

static bool add_body(Lab* lab, scree_world* model, scree_body body)
{
	scree_body_def def;
	int count = 0;
	if (!read_def(model, body, &def) || !report(scree_body_get_collidables(model, body, NULL, 0, &count)))
		return false;
	scree_collidable* collidables = require_memory(malloc(((size_t)count + 1) * sizeof *collidables));
	LabPart* parts = require_memory(malloc(((size_t)count + 1) * sizeof *parts));
	bool good = report(scree_body_get_collidables(model, body, collidables, count, &count));
	for (int k = 0; k < count && good; ++k)
		good = read_part(model, collidables[k], &parts[k]);
	if (good)
		lab_add(lab, &def, parts, count);
	free(collidables);
	free(parts);
	return good;
}

static bool add_bodies(Lab* lab, scree_world* model)
{
	int count = 0;
	scree_world_get_bodies(model, NULL, 0, &count);
	scree_body* bodies = require_memory(malloc(((size_t)count + 1) * sizeof *bodies));
	bool good = report(scree_world_get_bodies(model, bodies, count, &count));
	for (int k = 0; k < count && good; ++k)
		good = add_body(lab, model, bodies[k]);
	free(bodies);
	return good;
}

Lab* lab_scene(Validation* v, const char* name, const SceneSetting* setting)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	Scene* scene =
	    scene_find(name, v->executable, path, sentence) ? scene_load(path, setting, setting != NULL, sentence) : NULL;
	LabDef def = lab_def();
	scree_world* model = NULL;
	if (!scene)
		fprintf(stderr, "scree validate: %s\n", sentence);
	else
	{
		def = (LabDef){scene->world.gravity, scene->dt, scene->substeps, scene->world.max_speed, false, 0.0f};
		scree_world_def flat = scene->world;
		flat.device = "cpu";
		flat.threads = 1;
		if (!report(scree_world_create(&flat, &model)) || !report(scene_build(scene, model)))
			v->broken = true;
	}
	v->broken = v->broken || !scene;
	Lab* lab = lab_open(v, &def);
	if (!v->broken && !add_bodies(lab, model))
		v->broken = true;
	scree_world_destroy(model);
	scene_free(scene);
	return lab;
}
