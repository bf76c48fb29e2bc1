// SPDX-License-Identifier: MIT
// step2_hero.c -- step 2 of the first game: a character walks, jumps and pushes crates.
#include "hero.h"
#include "level.h"
#include "paint.h"

int main(int argc, char** argv)
{
	scree_fail_hook_set(window_fail, NULL);
	Window window = window_open("Step 2: a character", argc, argv);
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.threads = window.threads;
	scree_world_create(&def, &world);

	level_create(world);
	Hero hero = hero_create(world, -8.0f, 1.0f);

	scree_clock clock = scree_clock_default(1.0f / 60.0f);
	while (window_next(&window))
	{
		for (int left = scree_clock_advance(&clock, window.seconds); left > 0; --left)
		{
			hero_step(&hero, world, window_keys(&window), clock.dt);
			scree_world_step(world, clock.dt, 4);
		}
		paint(&window, world, hero.body, clock.alpha);
	}
	printf("the hero is at %.2f, %.2f\n", hero.mover.position.x, hero.mover.position.y);
	window_close(&window, world);
	scree_world_destroy(world);
	return 0;
}
