// SPDX-License-Identifier: MIT
// car.h -- the car of the first game: a body on two wheels, each with a spring and a motor.
#ifndef CAR_H
#define CAR_H
#include "hero.h"

#define COLOR_CAR   0xd05858c0u
#define COLOR_WHEEL 0x404858e0u

typedef struct Car
{
	scree_body body;
	scree_joint wheels[2];
} Car;

// Adds a wheel of 0.4 m at (x, y), m, with a spring of 4 Hz and a motor of at most 5 N m.
static inline scree_joint car_mount(scree_world* world, scree_body body, float x, float y)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_WHEEL);
	scree_joint joint;
	def.body_a = body;
	scree_body_create_circle(world, SCREE_BODY_DYNAMIC, scree_pose_make(x, y, 0.0f), 0.4f, COLOR_WHEEL, &def.body_b);
	// the spring acts along the x axis of the frames, so this axis points up
	scree_joint_def_place(world, &def, (scree_pose){{x, y}, {0.0f, 1.0f}});
	def.coordinates[SCREE_ALONG].spring_hertz = 4.0f;
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_max = 5.0f;
	scree_joint_create(world, &def, &joint);
	return joint;
}

static inline Car car_create(scree_world* world, float x, float y)
{
	Car car;
	scree_body_create_box(world, SCREE_BODY_DYNAMIC, scree_pose_make(x, y, 0.0f), 1.3f, 0.25f, COLOR_CAR, &car.body);
	car.wheels[0] = car_mount(world, car.body, x - 0.9f, y - 0.4f);
	car.wheels[1] = car_mount(world, car.body, x + 0.9f, y - 0.4f);
	return car;
}

// Turns the wheels by the keys while the hero stands on the car and the key "use" is down; brakes otherwise. Returns true if
// the hero drives. Called before the step of the world.
static inline bool car_step(Car* car, scree_world* world, const Hero* hero, uint8_t keys)
{
	bool drives = keys & KEY_USE && scree_body_equals(hero_ground(hero, world), car->body);
	float speed = drives ? -18.0f * hero_direction(keys) : 0.0f; // rad/s, clockwise to the right
	for (int k = 0; k < 2; ++k)
		scree_joint_set_motor_speed(world, car->wheels[k], SCREE_ANGLE, speed);
	return drives;
}

#endif
