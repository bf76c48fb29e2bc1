// SPDX-License-Identifier: MIT
// step4_car.c -- step 4 of the first game: the hero drives a car.
#include "car.h"
#include "coins.h"
#include "hero.h"
#include "level.h"
#include "paint.h"

int main(int argc, char** argv)
{
	scree_fail_hook_set(window_fail, NULL);
	Window window = window_open("Step 4: a car", argc, argv);
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.threads = window.threads;
	scree_world_create(&def, &world);

	level_create(world);
	Hero hero = hero_create(world, -8.0f, 1.0f);
	coins_create(world);
	int coins = 0;
	Car car = car_create(world, 8.0f, 0.9f);

	scree_clock clock = scree_clock_default(1.0f / 60.0f);
	while (window_next(&window))
	{
		for (int left = scree_clock_advance(&clock, window.seconds); left > 0; --left)
		{
			uint8_t keys = window_keys(&window);
			bool drives = car_step(&car, world, &hero, keys);
			hero_step(&hero, world, drives ? 0 : keys, clock.dt);
			scree_world_step(world, clock.dt, 4);
			coins += coins_take(world, &hero);
		}
		window_title(&window, "Step 4: %d coins", coins);
		paint(&window, world, hero.body, clock.alpha);
	}
	printf("%d coins; the hero is at %.2f, %.2f\n", coins, hero.mover.position.x, hero.mover.position.y);
	window_close(&window, world);
	scree_world_destroy(world);
	return 0;
}
