// SPDX-License-Identifier: MIT
// setup.c -- what is measured: a scene that was read from a file, or one that is made by code.
#include "setup.h"
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/find.h"
#include "scene/load.h"
#include "scree_world.h"

static bool load_rig(Setup* setup, const SceneSetting* settings, int count)
{
	for (int k = 0; k < RIG_PARAMETERS; ++k)
		setup->values[k] = setup->rig->parameters[k].value;
	for (int k = 0; k < count; ++k)
	{
		if (!rig_set(setup->rig, setup->values, settings[k].name, settings[k].value))
			return false;
	}
	setup->dt = 1.0f / 60.0f;
	setup->substeps = 4;
	setup->steps = setup->rig->steps;
	return true;
}

bool setup_load(Setup* setup, const char* name, const char* executable, const SceneSetting* settings, int count)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	*setup = (Setup){.rig = rig_find(name)};
	if (setup->rig)
		return load_rig(setup, settings, count);
	if (scene_find(name, executable, path, sentence))
		setup->scene = scene_load(path, settings, count, sentence);
	if (!setup->scene)
	{
		fprintf(stderr, "scree_peers: %s\n", sentence);
		return false;
	}
	if (setup->scene->field_count > 0 || setup->scene->blast_count > 0)
	{
		fprintf(stderr, "scree_peers: %s has fields or explosions, which other engines do not have\n", name);
		return false;
	}
	setup->dt = setup->scene->dt;
	setup->substeps = setup->scene->substeps;
	setup->steps = setup->scene->steps;
	return true;
}

void setup_free(Setup* setup) { scene_free(setup->scene); }

static bool fill(const Setup* setup, scree_world* world)
{
	if (setup->scene)
		return report(scene_build(setup->scene, world));
	RigBuild build = {world, setup->values, true};
	setup->rig->build(&build);
	return build.good;
}

scree_world* setup_open(const Setup* setup, const char* device, int threads)
{
	scree_world_def def = setup->scene ? setup->scene->world : scree_world_def_default();
	def.device = device;
	def.threads = threads;
	scree_world* world = NULL;
	if (report(scree_world_create(&def, &world)) && fill(setup, world))
		return world;
	scree_world_destroy(world);
	return NULL;
}

bool setup_change(const Setup* setup, scree_world* world, int64_t step)
{
	if (setup->scene)
		return report(scene_churn(setup->scene, world, step));
	RigBuild build = {world, setup->values, true};
	if (setup->rig->change)
		setup->rig->change(&build, step);
	return build.good;
}
