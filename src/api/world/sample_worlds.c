// SPDX-License-Identifier: MIT
// sample_worlds.c -- makes the small worlds by which devices are tested. Together they use contacts with friction,
// bounces and rolling, joints in colors and in a chain, a hub, and fields.
#include "api/world/sample_worlds.h"
#include "platform/error.h"

static scree_status add(scree_world* world, const scree_shape* shape, float x, float y, float angle, scree_body* body)
{
	scree_attribute_def attribute = scree_attribute_def_default();
	scree_body_def def = scree_body_def_default();
	attribute.shape = *shape;
	TRY(scree_attribute_create(world, &attribute, &def.attribute));
	def.pose = (scree_pose){{x, y}, scree_rot_make(angle)};
	return scree_body_create(world, &def, body);
}

static scree_status add_box(scree_world* world, float half_x, float half_y, float x, float y, scree_body* body)
{
	scree_shape shape;
	TRY(scree_shape_make_box(half_x, half_y, &shape));
	return add(world, &shape, x, y, 0.0f, body);
}

static scree_status add_floor(scree_world* world)
{
	scree_attribute_def attribute = scree_attribute_def_default();
	scree_body_def def = scree_body_def_default();
	TRY(scree_shape_make_box(12.0f, 0.5f, &attribute.shape));
	TRY(scree_attribute_create(world, &attribute, &def.attribute));
	def.type = SCREE_BODY_STATIC;
	def.pose = (scree_pose){{0.0f, -0.5f}, scree_rot_make(0.1f)};
	return scree_body_create(world, &def, NULL);
}

// Makes four kinds of shapes; circles bounce and roll.
static scree_status shapes_of(scree_world* world, scree_attribute attributes[4])
{
	const scree_vec corners[3] = {{-0.4f, -0.3f}, {0.45f, -0.3f}, {0.0f, 0.4f}};
	scree_shape shapes[4];
	TRY(scree_shape_make_box(0.4f, 0.3f, &shapes[0]));
	TRY(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.35f, &shapes[1]));
	TRY(scree_shape_make_capsule((scree_vec){-0.2f, 0.0f}, (scree_vec){0.2f, 0.05f}, 0.2f, &shapes[2]));
	TRY(scree_shape_make_polygon(corners, 3, 0.05f, &shapes[3]));
	for (int k = 0; k < 4; ++k)
	{
		scree_attribute_def def = scree_attribute_def_default();
		def.shape = shapes[k];
		def.restitution = k == 1 ? 0.4f : 0.0f;
		def.rolling_resistance = k == 1 ? 0.1f : 0.0f;
		TRY(scree_attribute_create(world, &def, &attributes[k]));
	}
	return SCREE_OK;
}

// 30 bodies of all shapes fall on a slope.
static scree_status fill_mixed(scree_world* world)
{
	scree_attribute attributes[4];
	TRY(shapes_of(world, attributes));
	TRY(add_floor(world));
	for (int k = 0; k < 30; ++k)
	{
		scree_body_def def = scree_body_def_default();
		def.attribute = attributes[k % 4];
		def.pose.position = (scree_vec){0.83f * (float)(k % 6) - 2.5f, 0.97f * (float)(k / 6) + 0.9f};
		def.pose.rotation = scree_rot_make(0.37f * (float)k);
		def.velocity.linear = (scree_vec){0.3f * (float)(k % 3), -4.0f};
		TRY(scree_body_create(world, &def, NULL));
	}
	return SCREE_OK;
}

// A pyramid of 28 boxes stands on a slope; a heavy box hits it.
static scree_status fill_stack(scree_world* world)
{
	TRY(add_floor(world));
	for (int row = 0; row < 7; ++row)
		for (int k = 0; k < 7 - row; ++k)
			TRY(add_box(world, 0.25f, 0.25f, 0.55f * (float)k + 0.275f * (float)row - 1.5f, 0.5f * (float)row + 0.5f,
			            NULL));
	scree_body heavy;
	TRY(add_box(world, 1.0f, 0.5f, -5.0f, 1.3f, &heavy));
	return scree_body_set_velocity(world, heavy, (scree_velocity){{12.0f, 0.0f}, 1.0f});
}

static scree_status join(scree_world* world, scree_joint_def* def, scree_body a, scree_body b, float x, float y)
{
	def->body_a = a;
	def->body_b = b;
	TRY(scree_joint_def_place(world, def, (scree_pose){{x, y}, {1.0f, 0.0f}}));
	return scree_joint_create(world, def, NULL);
}

// A car on springs drives on a slope, with a swinging arm that has limits and a motor, and a welded load.
static scree_status add_car(scree_world* world)
{
	scree_body car, arm, load, wheel;
	scree_shape circle;
	TRY(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.4f, &circle));
	TRY(add_box(world, 1.2f, 0.3f, 0.0f, 1.0f, &car));
	for (int k = 0; k < 2; ++k)
	{
		float x = k ? 0.8f : -0.8f;
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_WHEEL);
		TRY(add(world, &circle, x, 0.6f, 0.0f, &wheel));
		def.coordinates[SCREE_ANGLE].motor = true;
		def.coordinates[SCREE_ANGLE].motor_speed = -15.0f;
		def.coordinates[SCREE_ANGLE].motor_max = 20.0f;
		TRY(join(world, &def, car, wheel, x, 0.6f));
	}
	scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_joint_coordinate* angle = &hinge.coordinates[SCREE_ANGLE];
	angle->motor = angle->limited = true;
	angle->motor_speed = 3.0f;
	angle->motor_max = 50.0f;
	angle->lower = -0.5f;
	angle->upper = 0.7f;
	TRY(add_box(world, 0.1f, 0.5f, 0.5f, 1.8f, &arm));
	TRY(join(world, &hinge, car, arm, 0.5f, 1.3f));
	scree_joint_def weld = scree_joint_def_make(SCREE_JOINT_WELD);
	TRY(add_box(world, 0.2f, 0.2f, -0.6f, 1.5f, &load));
	return join(world, &weld, car, load, -0.6f, 1.3f);
}

// A chain of 12 links hangs from the world and carries a box; besides, a car.
static scree_status fill_joints(scree_world* world)
{
	TRY(add_floor(world));
	TRY(add_car(world));
	scree_body last = {0};
	for (int k = 0; k <= 12; ++k)
	{
		scree_body link;
		float x = 3.0f + 0.4f * (float)k, size = k < 12 ? 0.2f : 0.5f;
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		TRY(add_box(world, size, k < 12 ? 0.05f : 0.5f, x + size, 6.0f, &link));
		TRY(join(world, &def, last, link, x, 6.0f));
		last = link;
	}
	return SCREE_OK;
}

// A plate lies on a slope and carries 40 boxes, and so has more contacts than fit in colors.
static scree_status fill_hub(scree_world* world)
{
	TRY(add_floor(world));
	TRY(add_box(world, 6.0f, 0.2f, 0.0f, 0.9f, NULL));
	for (int k = 0; k < 40; ++k)
		TRY(add_box(world, 0.12f, 0.12f, 0.28f * (float)k - 5.5f, 1.22f + 0.02f * (float)(k % 3), NULL));
	return SCREE_OK;
}

// Circles, capsules and segments in water, in a whirl, and in wind.
static scree_status fill_fields(scree_world* world)
{
	TRY(add_floor(world));
	scree_shape shapes[3];
	TRY(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.3f, &shapes[0]));
	TRY(scree_shape_make_capsule((scree_vec){-0.3f, 0.0f}, (scree_vec){0.3f, 0.1f}, 0.15f, &shapes[1]));
	TRY(scree_shape_make_box(0.3f, 0.2f, &shapes[2]));
	for (int k = 0; k < 24; ++k)
		TRY(add(world, &shapes[k % 3], 0.7f * (float)(k % 8) - 2.5f, 0.8f * (float)(k / 8) + 0.9f, 0.3f * (float)k,
		        NULL));
	scree_attribute_def edge = scree_attribute_def_default();
	scree_body_def wall = scree_body_def_default();
	TRY(scree_shape_make_segment((scree_vec){0.0f, 0.0f}, (scree_vec){1.0f, 4.0f}, &edge.shape));
	TRY(scree_attribute_create(world, &edge, &wall.attribute));
	wall.type = SCREE_BODY_STATIC;
	wall.pose.position.x = 3.5f;
	TRY(scree_body_create(world, &wall, NULL));

	scree_field_def water = scree_field_def_default(SCREE_FIELD_BUOYANCY);
	TRY(scree_shape_make_box(10.0f, 1.5f, &water.shape));
	water.density = 2.0f;
	TRY(scree_field_create(world, &water, NULL));
	scree_field_def whirl = scree_field_def_default(SCREE_FIELD_VORTEX);
	whirl.pose.position.y = 2.0f;
	TRY(scree_field_create(world, &whirl, NULL));
	scree_field_def wind = scree_field_def_default(SCREE_FIELD_WIND);
	wind.velocity = (scree_vec){6.0f, 1.0f};
	wind.lift = 0.5f;
	return scree_field_create(world, &wind, NULL);
}

const SampleWorld sample_worlds[SAMPLE_WORLDS] = {
    {"mixed", fill_mixed}, {"stack", fill_stack}, {"joints", fill_joints}, {"hub", fill_hub}, {"fields", fill_fields},
};
