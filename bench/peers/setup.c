// SPDX-License-Identifier: MIT
// setup.c -- loads the scene of a trial, from a file or made by code, and builds it in a world.
#include "setup.h"
#include "fixtures.h"
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/find.h"
#include "scene/load.h"
#include "validate/scree_world.h"

static bool load_fixture(Setup* setup, const SceneSetting* settings, int count)
{
	for (int k = 0; k < FIXTURE_PARAMETERS; ++k)
		setup->values[k] = setup->fixture->parameters[k].value;
	for (int k = 0; k < count; ++k)
	{
		if (!fixture_set(setup->fixture, setup->values, settings[k].name, settings[k].value))
			return false;
	}
	setup->dt = 1.0f / 60.0f;
	setup->substeps = 4;
	setup->steps = setup->fixture->steps;
	return true;
}

bool setup_load(Setup* setup, const char* name, const char* executable, const SceneSetting* settings, int count)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	*setup = (Setup){.fixture = fixture_find(name)};
	if (setup->fixture)
		return load_fixture(setup, settings, count);
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

bool setup_fill(const Setup* setup, scree_world* world)
{
	if (setup->scene)
		return report_status(scene_build(setup->scene, world));
	FixtureBuild build = {world, setup->values, true};
	setup->fixture->build(&build);
	return build.good;
}

scree_world_def setup_world(const Setup* setup)
{
	scree_world_def def = setup->scene ? setup->scene->world : scree_world_def_default();
	return def;
}

scree_world* setup_open(const Setup* setup, int threads)
{
	scree_world_def def = setup_world(setup);
	def.device = "cpu";
	def.threads = threads;
	def.sleep = false;
	scree_world* world = NULL;
	if (report_status(scree_world_create(&def, &world)) && setup_fill(setup, world))
		return world;
	scree_world_destroy(world);
	return NULL;
}

bool setup_changes(const Setup* setup)
{
	return setup->scene ? scene_churns(setup->scene) : setup->fixture->change != NULL;
}

bool setup_change(const Setup* setup, scree_world* world, int64_t step)
{
	if (setup->scene)
		return report_status(scene_churn(setup->scene, world, step));
	FixtureBuild build = {world, setup->values, true};
	if (setup->fixture->change)
		setup->fixture->change(&build, step);
	return build.good;
}
