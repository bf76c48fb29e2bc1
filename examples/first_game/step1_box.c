// SPDX-License-Identifier: MIT
// step1_box.c -- step 1 of the first game: a crate falls on the ground.
#include "window.h"
#include <scree/scree_math.h>

int main(int argc, char** argv)
{
	scree_fail_hook_set(window_fail, NULL);
	Window window = window_open("Step 1: a falling box", argc, argv);
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.threads = window.threads;
	scree_world_create(&def, &world);

	// ground: 20 m wide, 1 m high, top at y = 0; crate: 1 m wide, 6 m above it, turned by 0.3 radians
	scree_body_create_box(world, SCREE_BODY_STATIC, scree_pose_make(0.0f, -0.5f, 0.0f), 10.0f, 0.5f, 0, NULL);
	scree_body_create_box(world, SCREE_BODY_DYNAMIC, scree_pose_make(0.0f, 6.0f, 0.3f), 0.5f, 0.5f, 0, NULL);

	scree_clock clock = scree_clock_default(1.0f / 60.0f);
	while (window_next(&window))
	{
		for (int left = scree_clock_advance(&clock, window.seconds); left > 0; --left)
			scree_world_step(world, clock.dt, 4);
		view_draw(world, &window.view, SCREE_DRAW_SHAPES);
	}
	window_close(&window, world);
	scree_world_destroy(world);
	return 0;
}
