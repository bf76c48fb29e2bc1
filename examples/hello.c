// SPDX-License-Identifier: MIT
// hello.c -- the shortest program: a box falls on the ground, and its final height is printed.
#include <inttypes.h>
#include <scree/scree.h>
#include <stdio.h>
#include <stdlib.h>

static void check(scree_status status)
{
	if (status != SCREE_OK)
	{
		fprintf(stderr, "%s\n", scree_error());
		exit(1);
	}
}

int main(void)
{
	scree_world_def world_def = scree_world_def_default();
	scree_world* world;
	check(scree_world_create(&world_def, &world));

	// ground: 40 m wide, 1 m high, top at y = 0
	scree_attribute_def attribute_def = scree_attribute_def_default();
	scree_body_def body_def = scree_body_def_default();
	scree_body ground, box;
	check(scree_shape_make_box(20.0f, 0.5f, &attribute_def.shape));
	check(scree_attribute_create(world, &attribute_def, &body_def.attribute));
	body_def.type = SCREE_BODY_STATIC;
	body_def.pose.position.y = -0.5f;
	check(scree_body_create(world, &body_def, &ground));

	// box: 1 m wide, dropped from 10 m
	check(scree_shape_make_box(0.5f, 0.5f, &attribute_def.shape));
	check(scree_attribute_create(world, &attribute_def, &body_def.attribute));
	body_def.type = SCREE_BODY_DYNAMIC;
	body_def.pose.position.y = 10.0f;
	check(scree_body_create(world, &body_def, &box));

	for (int i = 0; i < 180; ++i)
		check(scree_world_step(world, 1.0f / 60.0f, 4));

	scree_pose pose;
	uint64_t hash;
	check(scree_body_get_pose(world, box, &pose));
	check(scree_world_get_hash(world, &hash));
	printf("%s: the box rests at %.3f, %.3f; hash %016" PRIx64 "\n", scree_world_get_device(world), pose.position.x,
	       pose.position.y, hash);
	scree_world_destroy(world);
	return 0;
}
