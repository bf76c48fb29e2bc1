// SPDX-License-Identifier: MIT
// small_scenes.h -- creates scenarios of all scenes, small enough for a test to run on many devices.
#ifndef SMALL_SCENES_H
#define SMALL_SCENES_H
#include "scene/player.h"
#include "support/load_scene.h"
#include "support/scenarios.h"
#include "support/small_sizes.h"
#include <stdlib.h>
#include <string.h>

static ScenePlayer small_players[2]; // players of the last two worlds that were built

static inline ScenePlayer* player_of(const scree_world* world)
{
	return small_players + (small_players[1].world == world);
}

static inline void build_scene(scree_world* world, const void* context)
{
	static int turn;
	turn = !turn;
	for (int k = 0; k < 2; ++k)
		if (k == turn || small_players[k].world == world) // a new world may have the address of a destroyed world
			player_close(small_players + k);
	OK(player_fill(small_players + turn, context, world));
}

static inline void change_scene(scree_world* world, int step, const void* context)
{
	(void)context;
	ScenePlayer* player = player_of(world);
	player->steps = step;
	OK(player_change(player));
}

// Returns the scenario of a scene. The caller frees the context of the scenario by scene_free. The test fails if
// small_sizes.h has no line for the scene.
static inline Scenario small_scene(const char* name)
{
	const SmallScene* small = NULL;
	for (size_t k = 0; k < sizeof small_scenes / sizeof *small_scenes; ++k)
		if (strcmp(small_scenes[k].name, name) == 0)
			small = small_scenes + k;
	if (!small)
		fail_msg("scene %s has no line in small_sizes.h", name);
	Scene* scene = load_scene(name, small->settings);
	return (Scenario){.name = small->name,
	                  .def = scene->world,
	                  .dt = scene->dt,
	                  .substeps = scene->substeps,
	                  .steps = quick() ? small->steps / 4 : small->steps,
	                  .build = build_scene,
	                  .act = change_scene,
	                  .context = scene};
}

// Creates the scenario of every scene of the project, and calls a function for each scenario.
static inline void for_every_scene(void (*check)(const Scenario* scenario))
{
	char **names, missing[SCENE_SENTENCE];
	int count = scene_list(NULL, &names, missing);
	assert_true(count > 0);
	for (int k = 0; k < count; ++k)
	{
		Scenario scenario = small_scene(names[k]);
		check(&scenario);
		scene_free((Scene*)scenario.context);
		free(names[k]);
	}
	free(names);
}

// Opens a scene after some of its steps.
static inline scree_world* scene_world(const Scenario* scenario, int steps)
{
	scree_world_def def = scenario->def;
	scree_world* world;
	def.device = "cpu";
	def.threads = 1;
	OK(scree_world_create(&def, &world));
	scenario->build(world, scenario->context);
	for (int step = 0; step < steps; ++step)
	{
		scenario->act(world, step, scenario->context);
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
	}
	return world;
}

#endif
