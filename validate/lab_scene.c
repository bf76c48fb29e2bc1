// SPDX-License-Identifier: MIT
// lab_scene.c -- makes a lab from a scene file: builds the scene in a Scree world, and copies the bodies of that world
// into the lab.
#include "lab_scene.h"
#include "experiment_support.h"
#include "scene/find.h"
#include "scene/load.h"
#include "scene/player.h"
#include "scree_world.h"
#include <stdlib.h>

static bool add_bodies(Lab* lab, scree_world* model)
{
	int count = 0;
	scree_body* bodies = require_memory(list_bodies(model, &count));
	bool good = true;
	for (int k = 0; k < count && good; ++k)
	{
		EngineBody body;
		good = read_body(model, bodies[k], &body);
		if (good)
			lab_add(lab, &body.def, body.parts, body.count);
		free(body.parts);
	}
	free(bodies);
	return good;
}

Lab* lab_scene(Validation* v, const char* name, const SceneSetting* setting)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	Scene* scene =
	    scene_find(name, v->executable, path, sentence) ? scene_load(path, setting, setting != NULL, sentence) : NULL;
	LabDef def = lab_def();
	ScenePlayer model = {0};
	if (!scene)
		fprintf(stderr, "scree validate: %s\n", sentence);
	else
	{
		def = (LabDef){scene->world.gravity, scene->dt, scene->substeps, scene->world.max_speed, false, 0.0f};
		scree_world_def flat = scene->world;
		flat.device = "cpu";
		flat.threads = 1;
		if (!report_status(player_open(&model, scene, &flat)))
			v->broken = true;
	}
	v->broken = v->broken || !scene;
	Lab* lab = lab_open(v, &def);
	if (!v->broken && !add_bodies(lab, model.world))
		v->broken = true;
	player_close(&model);
	scene_free(scene);
	return lab;
}
