// SPDX-License-Identifier: MIT
// fixture_car.c -- builds a scene: a car with springs and motors at its two wheels drives on rough ground.
#include "fixtures.h"

#define PI     3.14159265f
#define WHEEL  0.4f // m: radius of a wheel
#define FIRST  -20  // m: x at the left end of the ground
#define GROUND 1200 // m: length of the ground

enum
{
	SPEED,
	ROUGHNESS
};

// Returns a random height of the ground at x = k, in units of the roughness, -1 to 1; the same on every machine.
static float height_of(int k)
{
	uint32_t word = (uint32_t)(k + 1000) * 2654435761u;
	word ^= word >> 15;
	word *= 2246822519u;
	word ^= word >> 13;
	return (float)(word & 0xffff) / 32767.5f - 1.0f;
}

static void add_ground(FixtureBuild* build, float roughness)
{
	for (int k = FIRST; k < GROUND + FIRST; ++k)
	{
		float left = k < 5 ? 0.0f : roughness * height_of(k), right = k < 4 ? 0.0f : roughness * height_of(k + 1);
		scree_vec corners[4] = {{0.0f, -2.0f}, {1.0f, -2.0f}, {1.0f, right}, {0.0f, left}};
		scree_attribute_def part = fixture_polygon(build, corners, 4, 0.0f);
		part.friction = 0.9f;
		fixture_put(build, fixture_body(SCREE_BODY_STATIC, (float)k, 0.0f), &part);
	}
}

static void add_wheel(FixtureBuild* build, scree_body chassis, float x, float speed)
{
	scree_attribute_def tire = fixture_circle(build, WHEEL);
	tire.density = 2.0f;
	tire.friction = 1.5f;
	scree_body_def def = fixture_body(SCREE_BODY_DYNAMIC, x, WHEEL);
	def.velocity = (scree_velocity){{speed, 0.0f}, -speed / WHEEL};
	scree_body wheel = fixture_put(build, def, &tire);

	scree_joint_def joint =
	    fixture_joint(SCREE_JOINT_WHEEL, chassis, (scree_vec){x, WHEEL - 1.0f}, wheel, (scree_vec){0.0f, 0.0f});
	joint.frame_a.rotation = (scree_rot){0.0f, 1.0f};
	scree_joint_coordinate *along = &joint.coordinates[SCREE_ALONG], *angle = &joint.coordinates[SCREE_ANGLE];
	along->spring_hertz = 5.0f;
	along->spring_damping_ratio = 0.7f;
	along->limited = true;
	along->lower = -0.25f;
	along->upper = 0.25f;
	angle->motor = true;
	angle->motor_speed = -speed / WHEEL;
	angle->motor_max = 5.0f;
	fixture_join(build, &joint);
}

static void build_car(FixtureBuild* build)
{
	float speed = (float)build->values[SPEED];
	add_ground(build, (float)build->values[ROUGHNESS]);
	scree_attribute_def body = fixture_box(build, 1.4f, 0.3f);
	body.density = 4.0f;
	scree_body_def def = fixture_body(SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	def.velocity.linear.x = speed;
	def.locks = SCREE_LOCK_ROTATION; // at this speed a car that can rotate overturns sooner or later, in both engines
	scree_body chassis = fixture_put(build, def, &body);
	add_wheel(build, chassis, -1.0f, speed);
	add_wheel(build, chassis, 1.0f, speed);
}

const Fixture car_fixture = {"car", 600, {{"speed", 60}, {"roughness", 0.02}}, build_car, NULL};
