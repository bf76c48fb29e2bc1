// SPDX-License-Identifier: MIT
// test_joint_bounds.c -- checks maximum forces of springs and motors: separate bounds for push and pull, and a common
// bound for the coordinates along and across.
#include "support/make_joints.h"
#include <float.h>
#include <math.h>

// Adds a box of 1 kg with a given velocity.
static scree_body add_puck(scree_world* world, scree_velocity velocity)
{
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	OK(scree_body_set_mass(world, body, (scree_mass){1.0f, 0.2f, {0.0f, 0.0f}}));
	OK(scree_body_set_velocity(world, body, velocity));
	return body;
}

// A rubber band only pulls, and a bumper only pushes. Each is a spring of the same stiffness on one side of its target,
// and exerts no force on the other side.
static void springs_push_or_pull(void** state)
{
	(void)state;
	for (int pulls = 0; pulls < 2; ++pulls)
		for (int radial = 0; radial < 2; ++radial)
		{
			scree_world* world = open_world(0.0f);
			scree_body body = add_puck(world, (scree_velocity){{pulls ? -1.0f : 1.0f, 0.0f}, 0.0f});
			scree_joint_type type = radial ? SCREE_JOINT_DISTANCE : SCREE_JOINT_PRISMATIC;
			scree_joint_def def = joint_def_at(world, type, NOBODY, body, 0.0f, 0.0f, 0.0f);
			scree_joint_coordinate* along = &def.coordinates[SCREE_ALONG];
			def.frame_a.position.x = -4.0f;
			along->locked = false;
			along->target = 4.0f;
			along->spring = true;
			along->spring_hertz = 1.0f;
			*(pulls ? &along->spring_push : &along->spring_pull) = 0.0f;
			scree_joint joint = add_joint(world, &def);

			// the body keeps its speed on the side without a force
			run_steps(world, 30);
			NEAR(velocity_of(world, body).linear.x, pulls ? -1.0 : 1.0, 1e-5);
			NEAR(joint_state_of(world, joint).force.x, 0.0, 0.0);

			// the body turns around on the side with a force, within half a second
			OK(scree_body_set_pose(world, body, (scree_pose){{0.0f, 0.0f}, {1.0f, 0.0f}}));
			throw_body(world, body, pulls ? 1.0f : -1.0f, 0.0f, 0.0f);
			run_steps(world, 15);
			assert_true(pulls ? joint_state_of(world, joint).force.x < -1.0f
			                  : joint_state_of(world, joint).force.x > 1.0f);
			run_steps(world, 17);
			// a spring without damping returns all energy
			NEAR(velocity_of(world, body).linear.x, pulls ? -1.0 : 1.0, 1e-4);
			scree_world_destroy(world);
		}
}

// The force of a spring is limited by the smaller of two bounds: the common bound, and the bound for push or for pull.
static void bounds_of_a_side(void** state)
{
	(void)state;
	static const float bounds[][3] = {
	    {FLT_MAX, 3.0f, 5.0f}, {4.0f, 3.0f, 5.0f}, {2.0f, FLT_MAX, FLT_MAX}}; // N: common, for push, for pull
	for (int k = 0; k < 3; ++k)
		for (int side = -1; side <= 1; side += 2)
		{
			scree_world* world = open_world(0.0f);
			scree_body body = add_puck(world, (scree_velocity){0});
			scree_joint_def def = joint_def_at(world, SCREE_JOINT_PRISMATIC, NOBODY, body, 0.0f, 0.0f, 0.0f);
			scree_joint_coordinate* along = &def.coordinates[SCREE_ALONG];
			along->target = 100.0f * (float)side;
			along->spring = true;
			along->spring_hertz = 2.0f;
			along->spring_max = bounds[k][0];
			along->spring_push = bounds[k][1];
			along->spring_pull = bounds[k][2];
			add_joint(world, &def);
			run_steps(world, 60);
			NEAR(velocity_of(world, body).linear.x, side * fminf(bounds[k][0], bounds[k][side > 0 ? 1 : 2]), 1e-3);
			scree_world_destroy(world);
		}
}

// Friction of a box on a table, seen from above. With an elliptic bound, the box slows down equally in every direction,
// and moves in a straight line. Otherwise its speeds along and across the joint decrease separately.
static void friction_in_any_direction(void** state)
{
	(void)state;
	for (int elliptic = 0; elliptic < 2; ++elliptic)
		for (int k = 0; k < 16; ++k)
		{
			scree_world* world = open_world(0.0f);
			scree_rot direction = scree_rot_make((float)(2.0 * PI) * (float)k / 16.0f + 0.1f);
			scree_body body = add_puck(world, (scree_velocity){{4.0f * direction.c, 4.0f * direction.s}, 0.0f});
			scree_joint_def def = joint_def_at(world, SCREE_JOINT_MOTOR, NOBODY, body, 0.0f, 0.0f, 0.0f);
			def.coordinates[SCREE_ALONG].motor_max = def.coordinates[SCREE_ACROSS].motor_max = 2.0f;
			assert_true(def.elliptic);
			def.elliptic = elliptic;
			add_joint(world, &def);
			run_steps(world, 60);
			scree_vec v = velocity_of(world, body).linear;
			if (elliptic)
			{
				NEAR(v.x, 2.0 * direction.c, 2e-3);
				NEAR(v.y, 2.0 * direction.s, 2e-3);
			}
			else
				NEAR(fabs(v.x), fmax(4.0 * fabs(direction.c) - 2.0, 0.0), 2e-3);
			run_steps(world, 61);
			if (elliptic)
				assert_true(hypotf(velocity_of(world, body).linear.x, velocity_of(world, body).linear.y) < 1e-5f);
			scree_world_destroy(world);
		}
}

// A skate has little friction along its direction, and much across it. The bounds of the two forces are the axes of an
// ellipse. The skate stays at rest under a force inside the ellipse, and moves under a force outside it.
static void friction_of_a_skate(void** state)
{
	(void)state;
	const float most[2] = {1.0f, 5.0f};
	for (int k = 0; k < 8; ++k)
		for (int beyond = 0; beyond < 2; ++beyond)
		{
			scree_world* world = open_world(0.0f);
			scree_rot direction = scree_rot_make((float)PI / 4.0f * (float)k);
			float share = beyond ? 1.05f : 0.95f;
			scree_body body = add_puck(world, (scree_velocity){0});
			scree_joint_def def = joint_def_at(world, SCREE_JOINT_MOTOR, NOBODY, body, 0.0f, 0.0f, 0.0f);
			for (int axis = 0; axis < 2; ++axis)
				def.coordinates[axis].motor_max = most[axis];
			add_joint(world, &def);
			for (int i = 0; i < 60; ++i)
			{
				OK(scree_body_apply_force(world, body,
				                          (scree_vec){share * most[0] * direction.c, share * most[1] * direction.s}));
				run_steps(world, 1);
			}
			scree_vec v = velocity_of(world, body).linear;
			assert_true((hypotf(v.x, v.y) > 0.04f) == beyond);
			scree_world_destroy(world);
		}
}

// A target joint drags a body with a force of at most F in any direction. If one coordinate has the bound 0, the joint
// exerts no force along it.
static void targets_in_any_direction(void** state)
{
	(void)state;
	for (int k = 0; k < 8; ++k)
		for (int across = 0; across < 2; ++across)
		{
			scree_world* world = open_world(0.0f);
			scree_rot direction = scree_rot_make((float)PI / 4.0f * (float)k + 0.3f);
			scree_body body = add_puck(world, (scree_velocity){0});
			scree_joint_def def = joint_def_at(world, SCREE_JOINT_TARGET, NOBODY, body, 0.0f, 0.0f, 0.0f);
			def.frame_a.position = (scree_vec){1000.0f * direction.c, 1000.0f * direction.s};
			def.coordinates[SCREE_ALONG].spring_max = 3.0f;
			def.coordinates[SCREE_ACROSS].spring_max = across ? 3.0f : 0.0f;
			add_joint(world, &def);
			run_steps(world, 60);
			scree_vec v = velocity_of(world, body).linear;
			NEAR(v.x, across ? 3.0 * direction.c : copysign(3.0, direction.c), 2e-2);
			NEAR(v.y, across ? 3.0 * direction.s : 0.0, across ? 2e-2 : 0.0);
			scree_world_destroy(world);
		}
}

// A puck on a table, seen from above, has friction at a point 0.4 m beside its center of mass. A force of 15 N moves
// the puck against a friction of 10 N. The torque of this friction, 4 N m, is below the maximum torque of the friction
// against spin, 10 N m, so the puck does not turn. In an earlier version the puck turned at 0.005 rad/s.
static void friction_beside_the_center(void** state)
{
	(void)state;
	for (int k = 0; k < 4; ++k)
	{
		scree_world* world = open_world(0.0f);
		scree_rot direction = scree_rot_make((float)PI / 2.0f * (float)k);
		scree_body body = add_puck(world, (scree_velocity){0});
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_MOTOR, NOBODY, body, 0.4f, 0.0f, 0.0f);
		for (int c = 0; c < 3; ++c)
			def.coordinates[c].motor_max = 10.0f;
		add_joint(world, &def);
		for (int n = 0; n < 60; ++n)
		{
			OK(scree_body_apply_force(world, body, (scree_vec){15.0f * direction.c, 15.0f * direction.s}));
			run_steps(world, 1);
		}
		NEAR(velocity_of(world, body).angular, 0.0, 1e-4);
		NEAR(velocity_of(world, body).linear.x, 5.0 * direction.c, 0.01);
		NEAR(velocity_of(world, body).linear.y, 5.0 * direction.s, 0.01);
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(springs_push_or_pull),      cmocka_unit_test(bounds_of_a_side),
	    cmocka_unit_test(friction_in_any_direction), cmocka_unit_test(friction_of_a_skate),
	    cmocka_unit_test(targets_in_any_direction),  cmocka_unit_test(friction_beside_the_center),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
