// SPDX-License-Identifier: MIT
// scree_world.c -- Scree worlds of scenes, and the errors of Scree.
#include "scree_world.h"
#include "scene/build.h"
#include <stdlib.h>

bool report(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "scree_peers: %s\n", scree_error());
	return status == SCREE_OK;
}

scree_world* open_world(const Scene* scene, const char* device, int threads)
{
	scree_world_def def = scene->world;
	def.device = device;
	def.threads = threads;
	scree_world* world = NULL;
	if (report(scree_world_create(&def, &world)) && report(scene_build(scene, world)))
		return world;
	scree_world_destroy(world);
	return NULL;
}

scree_body* list_bodies(const scree_world* world, int* count)
{
	*count = 0;
	scree_world_get_bodies(world, NULL, 0, count);
	scree_body* bodies = malloc(((size_t)*count + 1) * sizeof(scree_body));
	if (bodies)
		scree_world_get_bodies(world, bodies, *count, count);
	else
		fprintf(stderr, "scree_peers: no memory for %d bodies\n", *count);
	return bodies;
}
