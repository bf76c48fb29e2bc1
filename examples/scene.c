// SPDX-License-Identifier: MIT
// scene.c -- loads a scene file, steps it, and writes the world as another scene file.
#include <scree/scree_scene.h>
#include <stdio.h>
#include <stdlib.h>

// Scree calls this function if a call fails, so the program checks no result.
static void stop(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function, (void)status, (void)context;
	fprintf(stderr, "%s\n", sentence);
	exit(1);
}

int main(int count, char** arguments)
{
	scree_scene* scene;
	scree_scene_info info;
	scree_counters counters;
	if (count != 3)
		return fprintf(stderr, "usage: scene FROM.json TO.json\n"), 2;
	scree_fail_hook_set(stop, NULL);
	scree_scene_load(arguments[1], NULL, &scene);
	scree_scene_get_info(scene, &info);
	for (int step = 0; step < 60; ++step)
		scree_scene_step(scene);
	scree_world* world = scree_scene_get_world(scene);
	scree_world_get_counters(world, &counters);
	scree_scene_write(world, &info, arguments[2]);
	printf("%s: %d bodies after %d steps, written to %s\n", info.title, counters.bodies, 60, arguments[2]);
	scree_scene_destroy(scene);
	return 0;
}
