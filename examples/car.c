// SPDX-License-Identifier: MIT
// car.c -- the shortest program with joints: a car with two wheels on springs and a motor drives over a bump.
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

// Creates a body with one shape at (x, y), m.
static scree_body create(scree_world* world, scree_body_type type, scree_shape shape, float x, float y)
{
	scree_attribute_def attribute_def = scree_attribute_def_default();
	scree_body_def body_def = scree_body_def_default();
	scree_body body;
	attribute_def.shape = shape;
	attribute_def.friction = 0.9f;
	check(scree_attribute_create(world, &attribute_def, &body_def.attribute));
	body_def.type = type;
	body_def.pose.position = (scree_vec){x, y};
	check(scree_body_create(world, &body_def, &body));
	return body;
}

// Adds a wheel at (x, y) to the car, with a spring of 4 Hz and a motor of at most 3 N m.
static void mount(scree_world* world, scree_body car, float x, float y)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_WHEEL);
	scree_joint_coordinate *spring = &def.coordinates[SCREE_ALONG], *motor = &def.coordinates[SCREE_ANGLE];
	scree_shape circle;
	check(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.4f, &circle));
	def.body_a = car;
	def.body_b = create(world, SCREE_BODY_DYNAMIC, circle, x, y);
	// the x axis of the frames points upward, because the spring acts along that axis
	check(scree_joint_def_place(world, &def, (scree_pose){{x, y}, {0.0f, 1.0f}}));
	spring->spring_hertz = 4.0f;
	spring->limited = true;
	spring->lower = -0.25f;
	spring->upper = 0.25f;
	motor->motor = true;
	motor->motor_speed = -15.0f; // rad/s; clockwise, so that the car drives to the right
	motor->motor_max = 3.0f;
	check(scree_joint_create(world, &def, NULL));
}

int main(void)
{
	scree_world_def world_def = scree_world_def_default();
	scree_world* world;
	check(scree_world_create(&world_def, &world));

	// ground with its top at y = 0, a bump 0.2 m high at x = 5, and a car 2.4 m long on wheels of 0.4 m radius
	scree_shape ground, bump, box;
	check(scree_shape_make_box(50.0f, 0.5f, &ground));
	check(scree_shape_make_capsule((scree_vec){-0.5f, 0.0f}, (scree_vec){0.5f, 0.0f}, 0.2f, &bump));
	check(scree_shape_make_box(1.2f, 0.3f, &box));
	create(world, SCREE_BODY_STATIC, ground, 0.0f, -0.5f);
	create(world, SCREE_BODY_STATIC, bump, 5.0f, 0.0f);
	scree_body car = create(world, SCREE_BODY_DYNAMIC, box, 0.0f, 0.9f);
	mount(world, car, -0.8f, 0.4f);
	mount(world, car, 0.8f, 0.4f);

	for (int i = 0; i < 6; ++i)
	{
		scree_pose pose;
		for (int k = 0; k < 30; ++k)
			check(scree_world_step(world, 1.0f / 60.0f, 4));
		check(scree_body_get_pose(world, car, &pose));
		printf("%.1f s: the car is at %5.2f, %.2f\n", 0.5f * (float)(i + 1), pose.position.x, pose.position.y);
	}
	scree_world_destroy(world);
	return 0;
}
