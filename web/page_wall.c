// SPDX-License-Identifier: MIT
// page_wall.c -- the wall of the page: copies of a scene in one batch, each with its own random motor speeds.
#include "web/page.h"

#define MOST_BODIES 256 // maximum number of bodies of a scene in a wall, so that 64 copies of it run in a page

bool page_open_wall(Wall* wall, const Scene* scene, scree_world* world, int worlds, int threads)
{
	char sentence[SENTENCE];
	scree_counters counters;
	scree_batch_def def = scree_batch_def_default();
	def.worlds = worlds;
	def.threads = threads;
	if (!page_check(scree_world_get_counters(world, &counters)))
		return false;
	if (counters.bodies > MOST_BODIES)
	{
		snprintf(sentence, sizeof sentence, "%.100s has %d bodies, and a wall of worlds at most %d in each",
		         scene->name, counters.bodies, MOST_BODIES);
		return page_fail(sentence);
	}
	return wall_open(wall, scene, world, &def, sentence) || page_fail(sentence);
}

bool page_step_wall(void)
{
	double begin = emscripten_get_now();
	bool good = page_check(wall_step(&page.wall, &page.counters));
	page.milliseconds = emscripten_get_now() - begin;
	int stopped = good ? wall_stopped(&page.wall) : -1;
	if (stopped >= 0)
		snprintf(page.told, sizeof page.told, "World %d is paused, because it has too many contacts.", stopped);
	return good;
}

EMSCRIPTEN_KEEPALIVE int page_worlds(void) { return page.wall.batch ? page.wall.worlds : 0; }
