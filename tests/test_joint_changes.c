// SPDX-License-Identifier: MIT
// test_joint_changes.c -- checks joints that are created, changed and destroyed between steps, on the CPU and on
// OpenCL.
#include "support/make_joints.h"
#include "world/world.h"
#include <math.h>
#include <string.h>

static int joints_with(scree_world* world, scree_body body)
{
	int count;
	OK(scree_body_get_joints(world, body, NULL, 0, &count));
	return count;
}

// Two boxes that touch have a contact unless a joint between them prevents it. The contact returns once no joint
// prevents it.
static void joints_keep_bodies_apart(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f),
	           b = add_crate(world, SCREE_BODY_DYNAMIC, 1.0f, 0.0f);
	run_steps(world, 2);
	assert_int_equal(contacts_of(world), 1);
	scree_joint first = join(world, SCREE_JOINT_REVOLUTE, a, b, 0.5f, 0.0f);
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 0);
	scree_joint second = join(world, SCREE_JOINT_FILTER, b, a, 0.0f, 0.0f);
	OK(scree_joint_set_collide_connected(world, first, true));
	update_contacts(world);
	assert_int_equal(contacts_of(world), 0);
	OK(scree_joint_set_collide_connected(world, second, true));
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 1);
	OK(scree_joint_set_collide_connected(world, second, false));
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 0);
	OK(scree_joint_destroy(world, second));
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 1);

	// one box is moved away and disabled, so its joint does not act, and then comes back
	OK(scree_joint_set_collide_connected(world, first, false));
	OK(scree_body_set_pose(world, b, pose_at(0.0f, 30.0f, 0.0f)));
	OK(scree_body_set_enabled(world, b, false));
	run_steps(world, 1);
	OK(scree_body_set_pose(world, b, pose_at(0.9f, 0.0f, 0.0f)));
	OK(scree_body_set_enabled(world, b, true));
	run_steps(world, 2);
	assert_int_equal(contacts_of(world), 0);
	OK(scree_joint_destroy(world, first));
	run_steps(world, 2);
	assert_int_equal(contacts_of(world), 1);
	scree_world_destroy(world);
}

// The bodies of a joint collide from the step after the joint has broken.
static void broken_joints_let_bodies_collide(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body low = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f),
	           high = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_WELD, low, high, 0.0f, 1.0f, 0.0f);
	def.can_break = true;
	def.force_threshold = 100.0f;
	scree_joint joint = add_joint(world, &def);
	run_steps(world, 60);
	assert_int_equal(contacts_with(world, high), 0);
	OK(scree_body_apply_force(world, high, (scree_vec){0.0f, 400.0f}));
	run_steps(world, 1);
	scree_joint_event event;
	assert_int_equal(joint_events_of(world, &event, 1), 1);
	assert_true(event.broken && scree_joint_equals(event.joint, joint) && event.force > 100.0f);
	run_steps(world, 1);
	assert_int_equal(joint_events_of(world, NULL, 0), 0);
	run_steps(world, 240);
	assert_true(contacts_with(world, high) > 0);
	NEAR(fabs((double)pose_of(world, high).position.x) > 0.5 ? 0.5 : 1.5, pose_of(world, high).position.y, 0.02);

	// the joint stays broken after any change, and can be destroyed
	OK(scree_joint_set_thresholds(world, joint, 1e9f, 1e9f, false));
	OK(scree_joint_set_target(world, joint, SCREE_ALONG, 1.0f));
	run_steps(world, 10);
	assert_true(joint_state_of(world, joint).broken);
	assert_int_equal(joints_of(world), 1);
	OK(scree_joint_destroy(world, joint));
	joint = join(world, SCREE_JOINT_WELD, low, high, 0.0f, 1.0f);
	run_steps(world, 2);
	assert_false(joint_state_of(world, joint).broken);
	scree_world_destroy(world);
}

// A joint between a body and the world prevents no contact of this body, neither with static bodies nor with
// collidables that only report overlaps.
static void joints_with_the_world_keep_overlaps(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_collidable_def zone = scree_collidable_def_default();
	zone.attribute = box_attribute(world, 1.0f, 1.0f);
	OK(scree_collidable_create(world, &zone, NULL));
	run_steps(world, 2);
	int overlaps;
	for (int k = 0; k < 4; ++k)
	{
		OK(scree_world_get_overlaps(world, NULL, 0, &overlaps));
		assert_int_equal(overlaps, 2);
		assert_int_equal(contacts_of(world), 1);
		if (k == 3)
			break;
		join(world, SCREE_JOINT_MOTOR, SCREE_NULL_BODY, body, 0.0f, 0.0f);
		run_steps(world, 1);
	}
	scree_world_destroy(world);
}

// A joint prevents a contact of two bodies. Then one of the two is destroyed, and a new body takes its slot. No body
// has a contact, in the next step and later.
static void contacts_go_with_their_bodies(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f),
	           b = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	join(world, SCREE_JOINT_FILTER, a, b, 0.0f, 0.5f);
	run_steps(world, 2);
	OK(scree_body_destroy(world, a));
	a = add_crate(world, SCREE_BODY_DYNAMIC, 30.0f, 0.0f);
	for (int k = 0; k < 4; ++k)
	{
		run_steps(world, 1);
		assert_int_equal(contacts_of(world), 0);
		assert_int_equal(counters_of(world).contacts, 0);
	}
	expect_velocity(world, a, 0.0f, 0.0f, 0.0f);
	scree_world_destroy(world);
}

// A joint is destroyed when one of its bodies is destroyed. The handle of the joint is stale, even after the slot of
// the joint is reused.
static void joints_go_with_their_bodies(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body bodies[4];
	scree_joint joints[4], listed[4];
	for (int k = 0; k < 4; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 2.0f * (float)k, 0.0f);
	for (int k = 0; k < 3; ++k)
		joints[k] = join(world, SCREE_JOINT_WELD, bodies[k], bodies[k + 1], 2.0f * (float)k + 1.0f, 0.0f);
	joints[3] = join(world, SCREE_JOINT_REVOLUTE, bodies[1], SCREE_NULL_BODY, 2.0f, 0.0f);
	run_steps(world, 2);
	int count;
	OK(scree_body_get_joints(world, bodies[1], listed, 4, &count));
	assert_int_equal(count, 3);
	for (int k = 0; k < 3; ++k)
		assert_true(scree_joint_equals(listed[k], joints[k < 2 ? k : 3]));
	OK(scree_body_get_joints(world, bodies[1], listed, 1, &count));
	assert_true(count == 3 && scree_joint_equals(listed[0], joints[0]));

	OK(scree_body_destroy(world, bodies[1]));
	for (int k = 0; k < 4; ++k)
		assert_int_equal(scree_joint_is_valid(world, joints[k]), k == 2);
	assert_int_equal(joints_of(world), 1);
	assert_int_equal(joints_with(world, bodies[0]), 0);
	assert_int_equal(joints_with(world, bodies[2]), 1);
	assert_int_equal(scree_joint_destroy(world, joints[0]), SCREE_ERROR_STALE);
	assert_int_equal(scree_joint_set_target(world, joints[1], SCREE_ALONG, 1.0f), SCREE_ERROR_STALE);
	scree_joint_state unread;
	assert_int_equal(scree_joint_get_state(world, joints[3], &unread), SCREE_ERROR_STALE);

	// a new body and a new joint that take the slots of destroyed ones have no state of these
	bodies[1] = add_crate(world, SCREE_BODY_DYNAMIC, 50.0f, 0.0f);
	scree_joint fresh = join(world, SCREE_JOINT_WELD, bodies[0], bodies[1], 25.0f, 0.0f);
	assert_false(scree_joint_is_valid(world, joints[0]) || scree_joint_is_valid(world, joints[1]));
	run_steps(world, 1);
	NEAR(joint_state_of(world, fresh).force.x, 0.0, 0.0);
	expect_pose(world, bodies[1], pose_at(50.0f, 0.0f, 0.0f));
	scree_world_destroy(world);
}

// A joint between bodies that cannot move does not act. When one of its bodies becomes dynamic, the joint acts, and
// starts without impulses.
static void types_change(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body anchor = add_crate(world, SCREE_BODY_STATIC, 0.0f, 0.0f),
	           load = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, -2.0f);
	scree_joint joint = join(world, SCREE_JOINT_WELD, anchor, load, 0.0f, -1.0f);
	run_steps(world, 30);
	NEAR(joint_state_of(world, joint).force.y, 10.0, 0.01);
	OK(scree_body_set_type(world, load, SCREE_BODY_STATIC));
	run_steps(world, 30);
	assert_true(joint_state_of(world, joint).force.y == 0.0f);
	OK(scree_body_set_type(world, load, SCREE_BODY_DYNAMIC));
	OK(scree_body_set_type(world, anchor, SCREE_BODY_DYNAMIC));
	run_steps(world, 30);
	NEAR(velocity_of(world, anchor).linear.y, -5.0, 0.01);
	NEAR(velocity_of(world, load).linear.y, -5.0, 0.01);
	NEAR(joint_state_of(world, joint).force.y, 0.0, 0.01);

	// a kinematic anchor carries the load
	OK(scree_body_set_type(world, anchor, SCREE_BODY_KINEMATIC));
	throw_body(world, anchor, 1.0f, 0.0f, 0.0f);
	run_steps(world, 120);
	NEAR(velocity_of(world, load).linear.x, 1.0, 0.01);
	NEAR(pose_of(world, load).position.x, pose_of(world, anchor).position.x, 0.01);
	NEAR(joint_state_of(world, joint).force.y, 10.0, 0.1);
	scree_world_destroy(world);
}

// If one body of a joint is disabled, the joint does not act, so its other body falls freely. When the body is enabled,
// the joint pulls the two bodies together.
static void bodies_are_switched(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body anchor = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f),
	           load = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, -2.0f);
	join(world, SCREE_JOINT_REVOLUTE, SCREE_NULL_BODY, anchor, 0.0f, 0.0f);
	scree_joint joint = join(world, SCREE_JOINT_WELD, anchor, load, 0.0f, -1.0f);
	run_steps(world, 30);
	NEAR(joint_state_of(world, joint).force.y, 10.0, 0.01);
	OK(scree_body_set_enabled(world, anchor, false));
	run_steps(world, 6);
	NEAR(velocity_of(world, load).linear.y, -1.0, 1e-4);
	assert_true(joint_state_of(world, joint).force.y == 0.0f);
	OK(scree_body_set_enabled(world, anchor, true));
	run_steps(world, 120);
	NEAR(pose_of(world, load).position.y, -2.0, 0.01);
	NEAR(joint_state_of(world, joint).force.y, 10.0, 0.1);

	// the mass of the load is doubled
	OK(scree_body_set_mass(world, load, (scree_mass){2.0f, 0.5f, {0.0f, 0.0f}}));
	run_steps(world, 60);
	NEAR(joint_state_of(world, joint).force.y, 20.0, 0.1);
	scree_world_destroy(world);
}

// Frames, targets, thresholds and stiffness can be read exactly as they were set, and act from the next step on.
static void settings_are_read_and_act(void** state)
{
	(void)state;
	scree_world* world = stay_awake(open_test_world(-10.0f));
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_WELD, SCREE_NULL_BODY, body, 0.0f, 0.0f, 0.0f), now;
	def.user = 5;
	scree_joint joint = add_joint(world, &def);
	run_steps(world, 10);
	OK(scree_joint_set_frames(world, joint, pose_at(0.5f, 0.25f, 0.3f), pose_at(0.0f, 0.0f, 0.0f)));
	OK(scree_joint_set_stiffness(world, joint, 50.0f, 3.0f));
	OK(scree_joint_set_thresholds(world, joint, 7.0f, 8.0f, false));
	OK(scree_joint_set_user(world, joint, 9));
	OK(scree_joint_set_collide_connected(world, joint, true));
	OK(scree_joint_get_def(world, joint, &now));
	assert_true(now.type == SCREE_JOINT_WELD && scree_body_is_null(now.body_a) && scree_body_equals(now.body_b, body));
	assert_true(now.frame_a.position.x == 0.5f && now.frame_a.rotation.s == scree_rot_make(0.3f).s);
	assert_true(now.hertz == 50.0f && now.damping_ratio == 3.0f && now.user == 9 && now.collide_connected);
	assert_true(now.force_threshold == 7.0f && now.torque_threshold == 8.0f && !now.can_break);
	run_steps(world, 120);
	NEAR(pose_of(world, body).position.x, 0.5, 1e-3);
	NEAR(pose_of(world, body).position.y, 0.25, 1e-3);
	NEAR(scree_rot_get_angle(pose_of(world, body).rotation), 0.3, 1e-3);
	scree_joint_event event;
	assert_int_equal(joint_events_of(world, &event, 1), 1);
	assert_true(event.user == 9 && !event.broken);

	// events and states stay when the world moves to another device
	scree_joint_state there = joint_state_of(world, joint);
	OK(scree_world_move(world, "cpu"));
	scree_joint_state here = joint_state_of(world, joint);
	assert_memory_equal(&here.force, &there.force, sizeof here.force);
	assert_int_equal(joint_events_of(world, &event, 1), 1);
	assert_true(event.user == 9 && event.force > 7.0f);
	OK(scree_world_move(world, test_device));

	// replaces a lock by a motor, the motor by a spring, and then removes the spring
	scree_joint_coordinate across, read;
	OK(scree_joint_get_coordinate(world, joint, SCREE_ACROSS, &across));
	assert_true(across.locked && !across.limited);
	across.locked = false;
	across.motor = true;
	across.motor_speed = -1.0f;
	across.motor_max = 1e4f;
	OK(scree_joint_set_coordinate(world, joint, SCREE_ACROSS, &across));
	OK(scree_joint_get_coordinate(world, joint, SCREE_ACROSS, &read));
	assert_memory_equal(&read, &across, sizeof read);
	run_steps(world, 60);
	NEAR(joint_state_of(world, joint).values[SCREE_ACROSS], -1.0, 0.01);
	across.motor = false;
	across.spring = true;
	across.spring_hertz = 4.0f;
	across.spring_damping_ratio = 1.0f;
	OK(scree_joint_set_coordinate(world, joint, SCREE_ACROSS, &across));
	run_steps(world, 240);
	NEAR(joint_state_of(world, joint).values[SCREE_ACROSS], -10.0 * cos(0.3) / pow(8.0 * 3.14159265, 2.0), 1e-3);
	across.spring = false;
	OK(scree_joint_set_coordinate(world, joint, SCREE_ACROSS, &across));
	float before = velocity_of(world, body).linear.y;
	run_steps(world, 6);
	NEAR(velocity_of(world, body).linear.y - before, -10.0 * 0.1 * pow(cos(0.3), 2.0), 2e-3);
	scree_world_destroy(world);
}

// A disabled joint does not act, and its bodies may touch. When the joint is enabled, it starts without impulses. It
// keeps its number of turns.
static void joints_are_disabled(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body a = add_crate(world, SCREE_BODY_STATIC, 0.0f, 0.0f),
	           b = add_crate(world, SCREE_BODY_DYNAMIC, 0.9f, 0.0f);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, a, b, 0.0f, 0.0f, 0.0f);
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_speed = 20.0f;
	def.coordinates[SCREE_ANGLE].motor_max = 1e4f;
	def.disabled = true;
	scree_joint joint = add_joint(world, &def);
	assert_false(scree_joint_is_enabled(world, joint));
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 1);
	NEAR(joint_state_of(world, joint).force.y, 0.0, 0.0);
	run_steps(world, 60);
	assert_true(pose_of(world, b).position.y < -1.0f);

	// the joint is enabled and turns three times
	OK(scree_body_set_pose(world, b, pose_at(0.9f, 0.0f, 0.0f)));
	OK(scree_body_set_velocity(world, b, (scree_velocity){0}));
	OK(scree_joint_set_enabled(world, joint, true));
	assert_true(scree_joint_is_enabled(world, joint));
	run_steps(world, 60);
	assert_int_equal(contacts_of(world), 0);
	NEAR(joint_state_of(world, joint).values[SCREE_ANGLE], 20.0, 0.4);
	assert_true(joint_state_of(world, joint).torque != 0.0f);

	// setting the current value changes nothing
	float turned = joint_state_of(world, joint).values[SCREE_ANGLE];
	uint64_t before = hash_of(world);
	OK(scree_joint_set_enabled(world, joint, true));
	assert_true(hash_of(world) == before);
	run_steps(world, 1);
	NEAR(joint_state_of(world, joint).values[SCREE_ANGLE], turned + 20.0 / 60.0, 0.05);

	// the joint is disabled while it turns: the body flies off, and no threshold is exceeded
	OK(scree_joint_set_thresholds(world, joint, 0.0f, 0.0f, true));
	OK(scree_joint_set_enabled(world, joint, false));
	OK(scree_joint_set_enabled(world, joint, true));
	OK(scree_joint_set_enabled(world, joint, false));
	run_steps(world, 2);
	scree_joint_event event;
	assert_int_equal(joint_events_of(world, &event, 1), 0);
	assert_false(joint_state_of(world, joint).broken);
	NEAR(joint_state_of(world, joint).values[SCREE_ANGLE], turned + 3.0 * 20.0 / 60.0, 0.5);
	NEAR(joint_state_of(world, joint).torque, 0.0, 0.0);
	OK(scree_joint_get_def(world, joint, &def));
	assert_true(def.disabled && def.can_break);
	scree_world_destroy(world);
}

// A rope becomes two ropes when the joint in its middle is disabled, and one rope when this joint is enabled.
static void chains_are_disabled(void** state)
{
	(void)state;
	enum
	{
		LINKS = 20
	};
	scree_world* world = open_test_world(-10.0f);
	scree_body bodies[LINKS];
	scree_joint joints[LINKS];
	bool enabled[LINKS];
	for (int k = 0; k < LINKS; ++k)
	{
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, -1.5f * (float)k);
		joints[k] = join(world, SCREE_JOINT_REVOLUTE, k ? bodies[k - 1] : SCREE_NULL_BODY, bodies[k], 0.0f,
		                 0.75f - 1.5f * (float)k);
		enabled[k] = k != LINKS / 2;
	}
	run_steps(world, 60);
	NEAR(joint_state_of(world, joints[0]).force.y, 10.0 * LINKS, 1.0);
	OK(scree_joints_set_enabled(world, joints, enabled, LINKS));
	run_steps(world, 60);
	NEAR(joint_state_of(world, joints[0]).force.y, 5.0 * LINKS, 1.0);
	NEAR(pose_of(world, bodies[LINKS / 2 - 1]).position.y, -1.5 * (LINKS / 2 - 1), 0.01);
	NEAR(pose_of(world, bodies[LINKS - 1]).position.y, -1.5 * (LINKS - 1) - 5.0, 0.2);
	NEAR(joint_state_of(world, joints[LINKS - 1]).force.y, 0.0, 0.1);

	// the lower half has fallen, and the joint pulls the two halves together
	OK(scree_joint_set_enabled(world, joints[LINKS / 2], true));
	run_steps(world, 600);
	NEAR(joint_state_of(world, joints[0]).force.y, 10.0 * LINKS, 5.0);
	NEAR(pose_of(world, bodies[LINKS - 1]).position.y, -1.5 * (LINKS - 1), 0.05);
	scree_world_destroy(world);
}

// Each step creates one joint and destroys one. So slots, colors and places of impulses are reused.
static void joints_come_and_go(void** state)
{
	(void)state;
	enum
	{
		BODIES = 12
	};
	scree_world* world = open_test_world(-10.0f);
	scree_body bodies[BODIES];
	scree_joint joints[BODIES] = {SCREE_NULL_JOINT};
	add_floor(world);
	for (int k = 0; k < BODIES; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 1.5f * (float)k, 0.6f);
	for (int k = 0; k < 90; ++k)
	{
		int i = k * 5 % BODIES, other = (i + 1 + k % 3) % BODIES;
		if (scree_joint_is_valid(world, joints[i]))
			OK(scree_joint_destroy(world, joints[i]));
		joints[i] = join(world, (scree_joint_type)(k % 10), bodies[i], bodies[other], 1.5f * (float)i, 1.0f);
		run_steps(world, 1);
		assert_true(world->joints.used <= BODIES + 1);
		assert_int_equal(joints_of(world), k < BODIES ? k + 1 : BODIES);
	}
	for (int k = 0; k < BODIES; ++k)
		OK(scree_joint_destroy(world, joints[k]));
	assert_int_equal(joints_of(world), 0);
	run_steps(world, 200);
	for (int k = 0; k < BODIES; ++k)
		assert_true(fabsf(pose_of(world, bodies[k]).position.y) < 20.0f);
	scree_world_destroy(world);
}

// A step of 0 s changes no pose and no velocity of a body, and no impulse and no angle of a joint.
static void steps_of_no_time(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, SCREE_NULL_BODY, body, 0.0f, 0.0f, 0.0f);
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_speed = 10.0f;
	def.coordinates[SCREE_ANGLE].motor_max = 1e3f;
	scree_joint joint = add_joint(world, &def);
	update_contacts(world);
	expect_pose(world, body, pose_at(0.0f, 0.0f, 0.0f));
	expect_velocity(world, body, 0.0f, 0.0f, 0.0f);
	run_steps(world, 60);
	update_contacts(world);
	scree_joint_state first = joint_state_of(world, joint);
	uint64_t hash = hash_of(world);
	for (int k = 0; k < 5; ++k)
		update_contacts(world);
	scree_joint_state then = joint_state_of(world, joint);
	assert_true(hash_of(world) == hash);
	for (int k = 0; k < 3; ++k)
		assert_true(then.values[k] == first.values[k] && then.speeds[k] == first.speeds[k]);
	NEAR(then.values[SCREE_ANGLE], 10.0, 0.1);
	scree_pose pose = pose_of(world, body);
	run_steps(world, 1);
	NEAR(joint_state_of(world, joint).force.y, 10.0, 0.05);
	NEAR(pose_of(world, body).position.y, pose.position.y, 1e-4);
	scree_world_destroy(world);
}

// Returns the hash after a joint, which has no target of the angle, got one and then another, perhaps with a read in between.
static uint64_t hash_of_targets(bool reads)
{
	scree_world* world = open_test_world(0.0f);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_joint joint = join(world, SCREE_JOINT_REVOLUTE, NOBODY, crate, 0.0f, 0.0f);
	run_steps(world, 1);
	scree_joint_coordinate angle;
	OK(scree_joint_get_coordinate(world, joint, SCREE_ANGLE, &angle));
	angle.locked = true;
	OK(scree_joint_set_coordinate(world, joint, SCREE_ANGLE, &angle));
	if (reads)
		hash_of(world);
	OK(scree_joint_set_target(world, joint, SCREE_ANGLE, -4.0f));
	run_steps(world, 1);
	uint64_t hash = hash_of(world);
	scree_world_destroy(world);
	return hash;
}

// The number of whole turns of a joint is that of its first target, also if that is changed before the next step.
static void reads_between_targets_change_nothing(void** state)
{
	(void)state;
	assert_true(hash_of_targets(true) == hash_of_targets(false));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(joints_keep_bodies_apart),
	    cmocka_unit_test(broken_joints_let_bodies_collide),
	    cmocka_unit_test(joints_with_the_world_keep_overlaps),
	    cmocka_unit_test(contacts_go_with_their_bodies),
	    cmocka_unit_test(joints_go_with_their_bodies),
	    cmocka_unit_test(types_change),
	    cmocka_unit_test(bodies_are_switched),
	    cmocka_unit_test(settings_are_read_and_act),
	    cmocka_unit_test(joints_are_disabled),
	    cmocka_unit_test(chains_are_disabled),
	    cmocka_unit_test(joints_come_and_go),
	    cmocka_unit_test(steps_of_no_time),
	    cmocka_unit_test(reads_between_targets_change_nothing),
	};
	return RUN_ON_DEVICES(tests);
}
