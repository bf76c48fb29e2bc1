// SPDX-License-Identifier: MIT
// time.c -- frames of any length: slow motion with poses between two steps, and frames of 0.25 s beside a clock.
#include <scree/scree_math.h>
#include <stdio.h>
#include <stdlib.h>

#define CRATES 5

// Scree calls this function if a call fails, so the program checks no result.
static void stop(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function, (void)status, (void)context;
	fprintf(stderr, "%s\n", sentence);
	exit(1);
}

static void add_box(scree_world* world, scree_body_type type, scree_vec half, float x, float y)
{
	scree_body_create_box(world, type, scree_pose_make(x, y, 0.0f), half.x, half.y, 0, NULL);
}

// Opens a world with a ground, whose surface is at y = 0, and a stack of crates of 1 m, each 0.2 m beside the next.
static scree_world* open_stack(void)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.sleep = false;
	scree_world_create(&def, &world);
	add_box(world, SCREE_BODY_STATIC, (scree_vec){20.0f, 0.5f}, 0.0f, -0.5f);
	for (int k = 0; k < CRATES; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, (scree_vec){0.5f, 0.5f}, k % 2 ? -0.1f : 0.1f, 0.5f + (float)k);
	return world;
}

// Draws a frame. Body 0 is the ground, and the last body is the topmost crate.
static void draw(scree_world* world, const char* title, float alpha, int steps, double dropped)
{
	scree_pose poses[CRATES + 1];
	int count;
	scree_world_get_interpolated(world, alpha, NULL, poses, CRATES + 1, &count);
	printf("%s: %d steps, %.2f s dropped, the topmost crate is at %.4f, %.4f\n", title, steps, dropped,
	       poses[count - 1].position.x, poses[count - 1].position.y);
}

int main(void)
{
	scree_fail_hook_set(stop, NULL);
	// frames at 144 Hz in slow motion: one step in 9.6 frames, and each frame has poses of its own
	scree_world* world = open_stack();
	scree_clock clock = scree_clock_default(1.0f / 60.0f);
	add_box(world, SCREE_BODY_DYNAMIC, (scree_vec){0.2f, 0.2f}, 5.0f, 9.0f);
	clock.time_scale = 0.25f;
	for (int frame = 0; frame < 36; ++frame)
	{
		for (int left = scree_clock_advance(&clock, 1.0 / 144.0); left > 0; --left)
			scree_world_step(world, clock.dt, 4);
		scree_pose poses[CRATES + 2];
		int count;
		scree_world_get_interpolated(world, clock.alpha, NULL, poses, CRATES + 2, &count);
		if (frame % 5 == 0)
			printf("frame %2d: the box falls at %.4f m\n", frame, poses[count - 1].position.y);
	}
	scree_world_destroy(world);

	// ten frames of 0.25 s, each as one step: the solver cannot hold the stack, which sinks into itself
	world = open_stack();
	for (int frame = 0; frame < 10; ++frame)
		scree_world_step(world, 0.25f, 4);
	draw(world, "steps of 0.25 s", 1.0f, 10, 0.0);
	scree_world_destroy(world);

	// the same frames with a clock
	world = open_stack();
	clock = scree_clock_default(1.0f / 60.0f);
	int steps = 0;
	double dropped = 0.0;
	for (int frame = 0; frame < 10; ++frame)
	{
		for (int left = scree_clock_advance(&clock, 0.25); left > 0; --left, ++steps)
			scree_world_step(world, clock.dt, 4);
		dropped += clock.dropped;
	}
	draw(world, "steps of 1/60 s", clock.alpha, steps, dropped);
	scree_world_destroy(world);
	return 0;
}
