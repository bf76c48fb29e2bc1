// SPDX-License-Identifier: MIT
// small_scenes.h -- every scene at a size that a test can run on many devices. The golden hashes belong to these sizes.
#ifndef SMALL_SCENES_H
#define SMALL_SCENES_H
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/find.h"
#include "scene/load.h"
#include "scene/walk.h"
#include "support.h"
#include <stdlib.h>
#include <string.h>

typedef struct
{
	const char* name;
	int steps;
	SceneSetting settings[5]; // up to the first without a name
} SmallScene;

static const SmallScene small_scenes[] = {
    {"billiards", 300, {{"rack", "10"}}},
    {"blast", 240, {{"towers", "3"}, {"storeys", "5"}}},
    {"bridge", 240, {{"planks", "30"}}},
    {"cars", 240, {{"roads", "3"}}},
    {"chains", 240, {{"lengths", "4"}}}, // enough to lie side by side
    {"churn", 120, {{"columns", "20"}, {"rows", "16"}, {"moved", "12"}, {"replaced", "30"}}},
    {"cloth", 160, {{"columns", "24"}, {"rows", "20"}, {"pins", "4"}}},
    {"coaster", 240, {{"speed", "20"}}}, // reaches the loop
    {"dominoes", 240, {{"lines", "4"}, {"length", "16"}}},
    {"drift", 160, {{"boxes", "400"}}},
    {"gears", 240, {{"columns", "3"}, {"rows", "2"}}},
    {"lidar", 240, {{"robots", "60"}, {"rays", "30"}}},
    {"machine", 240, {{"columns", "3"}}},
    {"million", 120, {{"columns", "2"}, {"rows", "2"}, {"across", "12"}, {"high", "8"}}},
    {"pile", 200, {{"count", "300"}}},
    {"platformer", 400, {{NULL, NULL}}},
    {"platforms", 240, {{"columns", "3"}, {"rows", "4"}, {"jumpers", "20"}}},
    {"pond", 200, {{"boats", "3"}, {"balls", "36"}, {"crates", "12"}, {"fish", "75"}, {"stones", "100"}}},
    {"pyramid", 120, {{"rows", "24"}}},
    {"pyramids", 120, {{"columns", "4"}, {"rows", "3"}, {"base", "7"}}},
    {"ragdolls", 240, {{"columns", "5"}, {"rows", "3"}}},
    {"shapes", 240, {{NULL, NULL}}},
    {"slope", 240, {{NULL, NULL}}},
    {"smash", 200, {{"columns", "30"}, {"rows", "20"}, {"speed", "60"}}},
    {"storm", 160, {{"columns", "2"}, {"rows", "1"}, {"across", "12"}}},
    {"tumbler", 240, {{"side", "18"}, {"degrees", "90"}}},
    {"washer", 160, {{"radius", "13"}, {"plates", "48"}, {"spin", "0.6"}}},
    {"windmill", 240, {{"columns", "3"}, {"rows", "2"}}},
    {"wrecking-ball", 240, {{"links", "8"}, {"columns", "4"}, {"rows", "12"}}},
};

static inline void build_scene(scree_world* world, const void* context) { OK(scene_build(context, world)); }

static Walkers small_walkers; // the characters of the run

static inline void churn_scene(scree_world* world, int step, const void* context)
{
	if (step == 0)
	{
		walk_close(&small_walkers);
		OK(walk_open(&small_walkers, context, world));
	}
	OK(scene_churn(context, world, step));
	OK(walk_step(&small_walkers, world, step, 0));
}

// The story of a scene, which ends with scene_free of its context. A scene that has no size here fails the test.
static inline Story small_scene(const char* name)
{
	const SmallScene* small = NULL;
	for (size_t k = 0; k < sizeof small_scenes / sizeof *small_scenes; ++k)
		if (strcmp(small_scenes[k].name, name) == 0)
			small = small_scenes + k;
	if (!small)
		fail_msg("scene %s has no line in small_scenes.h", name);
	int settings = 0;
	while (settings < 5 && small->settings[settings].name)
		++settings;
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	if (!scene_find(name, NULL, path, sentence))
		fail_msg("%s", sentence);
	Scene* scene = scene_load(path, small->settings, settings, sentence);
	if (!scene)
		fail_msg("%s", sentence);
	return (Story){.name = small->name,
	               .def = scene->world,
	               .dt = scene->dt,
	               .substeps = scene->substeps,
	               .steps = quick() ? small->steps / 4 : small->steps,
	               .build = build_scene,
	               .act = churn_scene,
	               .context = scene};
}

// Calls check for the story of every scene that we ship.
static inline void for_every_scene(void (*check)(const Story* story))
{
	char **names, missing[SCENE_SENTENCE];
	int count = scene_list(NULL, &names, missing);
	assert_true(count > 0);
	for (int k = 0; k < count; ++k)
	{
		Story story = small_scene(names[k]);
		check(&story);
		scene_free((Scene*)story.context);
		free(names[k]);
	}
	free(names);
}

#endif
