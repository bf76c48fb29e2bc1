// SPDX-License-Identifier: MIT
// fixture_turning.c -- builds two scenes: a motor turns a bar among small bodies; a motor turns a box full of boxes.
#include "fixtures.h"
#include <float.h>
#include <math.h>

#define PI 3.14159265f

enum
{
	SIZE
};

// Adds a joint whose motor turns a body about its origin.
static void add_motor(FixtureBuild* build, scree_body body, scree_vec at, float speed, float torque)
{
	scree_joint_def def = fixture_joint(SCREE_JOINT_REVOLUTE, SCREE_NULL_BODY, at, body, (scree_vec){0.0f, 0.0f});
	scree_joint_coordinate* angle = &def.coordinates[SCREE_ANGLE];
	angle->motor = true;
	angle->motor_speed = speed;
	angle->motor_max = torque;
	fixture_join(build, &def);
}

// Adds a ring of thick boxes, because bodies without continuous collision would pass through thin lines.
static void add_ring(FixtureBuild* build, scree_vec center, float radius)
{
	const int sides = 360;
	const float half = 2.0f;
	scree_body_def def = fixture_body(SCREE_BODY_STATIC, center.x, center.y);
	scree_body ring = fixture_add(build, &def);
	scree_filter filter = scree_filter_default();
	float turn = 2.0f * PI / (float)sides, width = (radius + 2.0f * half) * tanf(0.5f * turn);
	for (int k = 0; k < sides; ++k)
	{
		scree_attribute_def side = fixture_box(build, half, width);
		scree_rot rotation = scree_rot_make(turn * (float)k);
		scree_pose pose = {{(radius + half) * rotation.c, (radius + half) * rotation.s}, rotation};
		build->good = build->good && scree_shape_transform(&side.shape, pose, &side.shape) == SCREE_OK;
		side.friction = 0.1f;
		fixture_attach(build, ring, &side, (scree_vec){0.0f, 0.0f}, filter);
	}
}

static void build_spinner(FixtureBuild* build)
{
	add_ring(build, (scree_vec){0.0f, 32.0f}, 40.0f);
	static const scree_vec corners[4] = {{-0.4f, -20.0f}, {0.4f, -20.0f}, {0.4f, 20.0f}, {-0.4f, 20.0f}};
	scree_attribute_def bar = fixture_polygon(build, corners, 4, 0.2f);
	bar.friction = 0.0f;
	scree_body spinner = fixture_put(build, fixture_body(SCREE_BODY_DYNAMIC, 0.0f, 12.0f), &bar);
	add_motor(build, spinner, (scree_vec){0.0f, 12.0f}, 5.0f, FLT_MAX);

	scree_attribute_def surfaces[3] = {
	    fixture_capsule(build, (scree_vec){-0.25f, 0.0f}, (scree_vec){0.25f, 0.0f}, 0.25f),
	    fixture_circle(build, 0.35f), fixture_box(build, 0.35f, 0.35f)};
	float x = -23.0f, y = 2.0f;
	for (int k = 0; k < (int)build->values[SIZE]; ++k)
	{
		scree_attribute_def* surface = &surfaces[k % 3];
		surface->friction = surface->restitution = 0.1f;
		surface->density = 0.25f;
		fixture_put(build, fixture_body(SCREE_BODY_DYNAMIC, x, y), surface);
		x += 0.5f;
		if (x >= 23.0f)
		{
			x = -23.0f;
			y += 0.5f;
		}
	}
}

const Fixture spinner_fixture = {"spinner", 500, {{"bodies", 6076}}, build_spinner, NULL};

static void build_drum(FixtureBuild* build)
{
	scree_body_def def = fixture_body(SCREE_BODY_DYNAMIC, 0.0f, 10.0f);
	scree_body drum = fixture_add(build, &def);
	scree_attribute_def upright = fixture_box(build, 0.5f, 10.0f), flat = fixture_box(build, 10.0f, 0.5f);
	upright.density = flat.density = 50.0f;
	for (float side = -10.0f; side <= 10.0f; side += 20.0f)
	{
		fixture_attach(build, drum, &upright, (scree_vec){side, 0.0f}, scree_filter_default());
		fixture_attach(build, drum, &flat, (scree_vec){0.0f, side}, scree_filter_default());
	}
	add_motor(build, drum, (scree_vec){0.0f, 10.0f}, 25.0f * PI / 180.0f, 1.0e8f);

	int size = (int)build->values[SIZE];
	scree_attribute_def box = fixture_box(build, 0.125f, 0.125f);
	for (int k = 0; k < size * size; ++k)
		fixture_put(build,
		            fixture_body(SCREE_BODY_DYNAMIC, 0.4f * (float)(k % size) - 0.2f * (float)size,
		                         0.4f * (float)(k / size) - 0.2f * (float)size + 10.0f),
		            &box);
}

const Fixture drum_fixture = {"drum", 750, {{"size", 45}}, build_drum, NULL};
