// SPDX-License-Identifier: MIT
// step7_replay.c -- step 7 of the first game: the keys of each step are saved and played again.
#include "bridge.h"
#include "car.h"
#include "coins.h"
#include "hero.h"
#include "lamp.h"
#include "level.h"
#include "paint.h"
#include "tape.h"

int main(int argc, char** argv)
{
	scree_fail_hook_set(window_fail, NULL);
	Window window = window_open("Step 7: a replay", argc, argv);
	Tape tape = tape_open(window_option(&window, "--record"), window_option(&window, "--replay"));
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.threads = window.threads;
	scree_world_create(&def, &world);

	level_create(world);
	Hero hero = hero_create(world, -8.0f, 1.0f);
	coins_create(world);
	int coins = 0;
	float bank = bridge_create(world, LEVEL_EDGE);
	level_block(world, bank, -6.0f, bank + 40.0f, 0.0f);
	Lamp lamp = lamp_create(world, bank + 11.0f, 5.0f);
	level_block(world, bank + 7.0f, 2.0f, bank + 8.5f, 2.3f); // roofs, below which the hero is in the shadow
	level_block(world, bank + 13.0f, 2.0f, bank + 14.5f, 2.3f);
	Car car = car_create(world, 8.0f, 0.9f);

	scree_clock clock = scree_clock_default(1.0f / 60.0f);
	while (!tape.ended && window_next(&window))
	{
		for (int left = scree_clock_advance(&clock, window.seconds); left > 0 && !tape.ended; --left)
		{
			uint8_t keys = tape_step(&tape, window_keys(&window));
			bool drives = car_step(&car, world, &hero, keys);
			hero_step(&hero, world, drives ? 0 : keys, clock.dt);
			scree_world_step(world, clock.dt, 4);
			coins += coins_take(world, &hero);
			lamp_step(&lamp, world, &hero);
		}
		window_title(&window, "Step 7: %d coins", coins);
		paint(&window, world, hero.body, clock.alpha);
		lamp_paint(&lamp, &window.view);
	}
	printf("%d coins; seen %d times; the hero is at %.2f, %.2f\n", coins, lamp.seen, hero.mover.position.x,
	       hero.mover.position.y);
	bool good = tape_close(&tape, world);
	window_close(&window, world);
	scree_world_destroy(world);
	return good ? 0 : 1;
}
