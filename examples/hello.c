// SPDX-License-Identifier: MIT
// hello.c -- the shortest program: a box falls on the ground, and its final height is printed.
#include <inttypes.h>
#include <scree/scree_math.h>
#include <stdio.h>
#include <stdlib.h>

// Scree calls this function if a call fails, so the program checks no result.
static void stop(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function, (void)status, (void)context;
	fprintf(stderr, "%s\n", sentence);
	exit(1);
}

int main(void)
{
	scree_fail_hook_set(stop, NULL);
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	scree_world_create(&def, &world);

	// ground: 40 m wide, 1 m high, top at y = 0; box: 1 m wide, dropped from 10 m
	scree_body box;
	scree_body_create_box(world, SCREE_BODY_STATIC, scree_pose_make(0.0f, -0.5f, 0.0f), 20.0f, 0.5f, 0, NULL);
	scree_body_create_box(world, SCREE_BODY_DYNAMIC, scree_pose_make(0.0f, 10.0f, 0.0f), 0.5f, 0.5f, 0, &box);

	for (int i = 0; i < 180; ++i)
		scree_world_step(world, 1.0f / 60.0f, 4);

	scree_pose pose;
	uint64_t hash;
	scree_body_get_pose(world, box, &pose);
	scree_world_get_hash(world, &hash);
	printf("%s: the box rests at %.3f, %.3f; hash %016" PRIx64 "\n", scree_world_get_device(world), pose.position.x,
	       pose.position.y, hash);
	scree_world_destroy(world);
	return 0;
}
