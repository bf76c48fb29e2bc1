// SPDX-License-Identifier: MIT
// test_joint_limits.c -- checks limits, ropes, soft locks, targets and thresholds of joints against the loads that they
// must hold.
#include "support/make_joints.h"
#include <float.h>
#include <math.h>
#include <string.h>

static double weight_of(scree_world* world, scree_body body)
{
	scree_mass mass = mass_of(world, body);
	return mass.mass * G;
}

// A motor turns a wheel against limits of -3 pi and 5 pi. The wheel stops at each limit, because the angle counts all
// turns.
static void angles_count_turns(void** state)
{
	(void)state;
	for (int direction = -1; direction <= 1; direction += 2)
	{
		scree_world* world = open_world(0.0f);
		scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, NOBODY, body, 0.0f, 0.0f, 0.0f);
		scree_joint_coordinate* angle = &def.coordinates[SCREE_ANGLE];
		angle->limited = angle->motor = true;
		angle->lower = (float)(-3.0 * PI);
		angle->upper = (float)(5.0 * PI);
		angle->motor_max = 10.0f;
		angle->motor_speed = 9.0f * (float)direction;
		scree_joint joint = add_joint(world, &def);
		double limit = direction < 0 ? -3.0 * PI : 5.0 * PI;
		for (int k = 0; k < 240; ++k)
		{
			run_steps(world, 1);
			double at = joint_state_of(world, joint).values[SCREE_ANGLE];
			assert_true(at > -3.0 * PI - 0.01 && at < 5.0 * PI + 0.01);
		}
		NEAR(joint_state_of(world, joint).values[SCREE_ANGLE], limit, 0.005);
		NEAR(joint_state_of(world, joint).torque, 0.0, 0.5);
		OK(scree_joint_set_motor_speed(world, joint, SCREE_ANGLE, -9.0f * (float)direction));
		run_steps(world, 400);
		NEAR(joint_state_of(world, joint).values[SCREE_ANGLE], direction < 0 ? 5.0 * PI : -3.0 * PI, 0.005);
		scree_world_destroy(world);
	}
}

// The angle of a wheel at 20 rad/s counts hundreds of turns.
static void wheels_turn_long(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_joint joint = join(world, SCREE_JOINT_REVOLUTE, NOBODY, body, 0.0f, 0.0f);
	OK(scree_body_set_angular_velocity(world, body, -20.0f));
	run_steps(world, 3600);
	NEAR(joint_state_of(world, joint).values[SCREE_ANGLE], -1200.0, 0.2);
	NEAR(velocity_of(world, body).angular, -20.0, 1e-3);
	scree_world_destroy(world);
}

// A slider on a slope of 30 degrees slides down to its limit. The limit carries m g sin 30, and the rail m g cos 30. A
// slider locks the angle of its body; a pin in a slot does not.
static void sliders_stop(void** state)
{
	(void)state;
	for (int slot = 0; slot < 2; ++slot)
	{
		scree_world* world = open_world((float)-G);
		scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.25f, 1.0f, 2.0f);
		scree_joint_def def = joint_def_at(world, slot ? SCREE_JOINT_SLOT : SCREE_JOINT_PRISMATIC, NOBODY, body, 1.0f,
		                                   2.0f, (float)PI / 6.0f);
		scree_joint_coordinate* along = &def.coordinates[SCREE_ALONG];
		along->limited = true;
		along->lower = -1.5f;
		along->upper = 0.5f;
		scree_joint joint = add_joint(world, &def);
		throw_body(world, body, 5.0f, 0.0f, slot ? 1.0f : 0.0f);
		double highest = 0.0, lowest = 0.0;
		for (int k = 0; k < 300; ++k)
		{
			run_steps(world, 1);
			scree_joint_state at = joint_state_of(world, joint);
			highest = fmax(highest, at.values[SCREE_ALONG]);
			lowest = fmin(lowest, at.values[SCREE_ALONG]);
			NEAR(at.values[SCREE_ACROSS], 0.0, 2e-3);
		}
		scree_joint_state at = joint_state_of(world, joint);
		double weight = weight_of(world, body);
		NEAR(highest, 0.5, 0.01);
		assert_true(lowest > -1.51);
		NEAR(at.values[SCREE_ALONG], -1.5, 1e-3);
		NEAR(at.force.x, 0.0, 0.01 * weight);
		NEAR(at.force.y, weight, 0.01 * weight);
		NEAR(position_of(world, body).x, 1.0 - 1.5 * cos(PI / 6.0), 2e-3);
		NEAR(position_of(world, body).y, 2.0 - 1.5 * 0.5, 2e-3);
		if (slot)
			NEAR(velocity_of(world, body).angular, 1.0, 1e-3);
		else
			NEAR(angle_of(world, body), 0.0, 1e-3);
		scree_world_destroy(world);
	}
}

// A rope is a distance joint with an upper limit. Below the limit the load falls freely. At the limit the rope carries
// the load.
static void ropes_are_slack(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, 0.3f, 0.0f), free_one;
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_DISTANCE);
	def.body_b = body;
	def.coordinates[SCREE_ALONG].locked = false;
	def.coordinates[SCREE_ALONG].limited = true;
	def.coordinates[SCREE_ALONG].upper = 2.0f;
	scree_joint joint = add_joint(world, &def);
	free_one = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, 9.0f, 0.0f);
	for (int k = 0; k < 34; ++k)
	{
		run_steps(world, 1);
		assert_true(velocity_of(world, body).linear.y == velocity_of(world, free_one).linear.y);
		assert_true(joint_state_of(world, joint).force.y == 0.0f);
	}
	double longest = 0.0;
	for (int k = 0; k < 1200; ++k)
	{
		run_steps(world, 1);
		longest = fmax(longest, hypot(position_of(world, body).x, position_of(world, body).y));
	}
	print_message("rope of 2 m: at most %.5f m\n", longest);
	NEAR(longest, 2.0, 0.01);
	OK(scree_body_set_damping(world, body, 1.0f, 1.0f));
	run_steps(world, 1200);
	NEAR(joint_state_of(world, joint).values[SCREE_ALONG], 2.0, 1e-3);
	NEAR(joint_state_of(world, joint).force.y, weight_of(world, body), 0.01 * weight_of(world, body));

	// the load is lifted, so the rope is slack
	OK(scree_body_set_pose(world, body, (scree_pose){{0.0f, -1.0f}, {1.0f, 0.0f}}));
	run_steps(world, 2);
	assert_true(joint_state_of(world, joint).force.y == 0.0f);
	scree_world_destroy(world);
}

// Locks follow moving targets and hold them. The targets are two translations, m, and an angle, rad, in frame A, which
// is rotated in the world.
static void targets_are_held(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_WELD);
	def.body_b = body;
	def.frame_a = (scree_pose){{1.0f, 2.0f}, scree_rot_make((float)PI / 3.0f)};
	scree_joint joint = add_joint(world, &def);
	static const float targets[3] = {0.5f, -0.25f, 4.0f};
	for (int step = 1; step <= 240; ++step)
	{
		float part = step < 120 ? (float)step / 120.0f : 1.0f;
		for (int k = 0; k < 3; ++k)
			OK(scree_joint_set_target(world, joint, (scree_coordinate)k, part * targets[k]));
		run_steps(world, 1);
	}
	scree_joint_state at = joint_state_of(world, joint);
	for (int k = 0; k < 3; ++k)
		NEAR(at.values[k], targets[k], 2e-3);
	scree_vec x = position_of(world, body);
	NEAR(x.x, 1.0 + 0.5 * 0.5 + 0.25 * sin(PI / 3.0), 2e-3);
	NEAR(x.y, 2.0 + 0.5 * sin(PI / 3.0) - 0.25 * 0.5, 2e-3);
	NEAR(remainder(angle_of(world, body) - PI / 3.0 - 4.0, 2.0 * PI), 0.0, 2e-3);
	scree_world_destroy(world);
}

// A lock that is soft along one axis yields only along that axis, by g sin(turn) / w^2, for any rotation `turn` of
// frame A. w: angular frequency of the lock.
static void soft_locks_have_a_direction(void** state)
{
	(void)state;
	for (int k = 0; k < 4; ++k)
	{
		double turn = k * PI / 4.0, w = 2.0 * PI * 2.0;
		scree_world* world = open_world((float)-G);
		scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_WELD, NOBODY, body, 0.0f, 0.0f, (float)turn);
		def.coordinates[SCREE_ALONG].lock_hertz = 2.0f;
		def.coordinates[SCREE_ALONG].lock_damping_ratio = 1.0f;
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 600);
		scree_joint_state at = joint_state_of(world, joint);
		print_message("soft along %.0f degrees: %.5f m along, %.5f m across\n", 45.0 * k, (double)at.values[0],
		              (double)at.values[1]);
		NEAR(at.values[SCREE_ALONG], -G * sin(turn) / (w * w), 2e-3);
		NEAR(at.values[SCREE_ACROSS], 0.0, 2e-3);
		scree_world_destroy(world);
	}
}

// The force at rest is m g. A joint breaks if its threshold is slightly below this force. If the threshold is slightly
// above it, the joint does not break, not even in its first step. A joint that only reports makes an event in every
// step.
static void joints_break_at_their_threshold(void** state)
{
	(void)state;
	static const scree_joint_type types[] = {SCREE_JOINT_REVOLUTE, SCREE_JOINT_WELD, SCREE_JOINT_DISTANCE,
	                                         SCREE_JOINT_PRISMATIC};
	for (int k = 0; k < 4; ++k)
		for (int above = 0; above < 3; ++above)
		{
			scree_world* world = stay_awake(open_world((float)-G));
			scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, -1.0f);
			double weight = weight_of(world, body);
			scree_joint_def def = joint_def_at(world, types[k], NOBODY, body, 0.0f, -1.0f, 0.0f);
			if (types[k] == SCREE_JOINT_DISTANCE)
				def.frame_a.position.y += 1.0f;
			def.force_threshold = (float)(weight * (above == 1 ? 1.005 : 0.995));
			def.can_break = above < 2;
			def.user = 77;
			scree_joint joint = add_joint(world, &def);
			int events = 0;
			for (int s = 0; s < 120; ++s)
			{
				run_steps(world, 1);
				scree_joint_event event;
				if (joint_events_of(world, &event, 1) == 0)
					continue;
				++events;
				assert_true(scree_joint_equals(event.joint, joint) && event.user == 77);
				assert_true(event.broken == (above == 0));
				NEAR(event.force, weight, 0.01 * weight);
			}
			assert_int_equal(events, above == 0 ? 1 : above == 1 ? 0 : 120);
			assert_true(joint_state_of(world, joint).broken == (above == 0));
			assert_true(scree_joint_is_valid(world, joint));
			if (above > 0)
				NEAR(position_of(world, body).y, -1.0, 1e-3);
			else
				assert_true(position_of(world, body).y < -10.0f);
			scree_world_destroy(world);
		}
}

// A weld that carries the torque m g l breaks if its threshold is slightly below this torque, and does not break if the
// threshold is slightly above it.
static void torques_break(void** state)
{
	(void)state;
	for (int above = 0; above < 2; ++above)
	{
		scree_world* world = open_world((float)-G);
		scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.1f, 0.5f, 0.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_WELD, NOBODY, body, 0.0f, 0.0f, 0.0f);
		def.torque_threshold = (float)(0.5 * weight_of(world, body) * (above ? 1.01 : 0.99));
		def.can_break = true;
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 120);
		assert_true(joint_state_of(world, joint).broken == !above);
		scree_world_destroy(world);
	}
}

// A spring or motor with the bound F cannot hold a load whose weight m g is larger than F. The load falls with the
// acceleration (m g - F) / m.
static void drives_are_limited(void** state)
{
	(void)state;
	for (int motor = 0; motor < 2; ++motor)
	{
		scree_world* world = open_world((float)-G);
		scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
		float most = (float)(0.75 * weight_of(world, body));
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_PRISMATIC, NOBODY, body, 0.0f, 0.0f, (float)PI / 2.0f);
		scree_joint_coordinate* along = &def.coordinates[SCREE_ALONG];
		along->motor = motor;
		along->motor_max = most;
		along->spring = !motor;
		along->spring_hertz = 10.0f;
		along->spring_damping_ratio = 1.0f;
		along->spring_max = most;
		add_joint(world, &def);
		run_steps(world, 60);
		float v = velocity_of(world, body).linear.y;
		run_steps(world, 60);
		NEAR(velocity_of(world, body).linear.y - v, -0.25 * G, 0.01);
		scree_world_destroy(world);
	}
}

// A spring with a stiffness of 0 or almost 0 neither pulls nor brakes.
static void springs_of_nothing(void** state)
{
	(void)state;
	static const float hertz[] = {0.0f, 1e-30f, FLT_MIN, 1e-12f};
	for (int k = 0; k < 8; ++k)
	{
		scree_world* world = open_world(0.0f);
		scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_PRISMATIC, NOBODY, body, 0.0f, 0.0f, 0.0f);
		def.coordinates[SCREE_ALONG].spring = true;
		def.coordinates[SCREE_ALONG].spring_hertz = hertz[k % 4];
		def.coordinates[SCREE_ALONG].spring_damping_ratio = k < 4 ? 0.0f : 1.0f;
		add_joint(world, &def);
		throw_body(world, body, 2.0f, 1.0f, 1.0f);
		run_steps(world, 60);
		NEAR(velocity_of(world, body).linear.x, 2.0, 1e-4);
		NEAR(velocity_of(world, body).linear.y, 0.0, 1e-3);
		NEAR(position_of(world, body).x, 2.0, 1e-3);
		scree_world_destroy(world);
	}
}

// A lock with almost no stiffness holds nothing. The other locks of the joint hold as usual.
static void soft_locks_of_nothing(void** state)
{
	(void)state;
	static const float hertz[] = {1e-30f, 1e-20f, FLT_MIN, 1e-12f};
	for (int k = 0; k < 8; ++k)
	{
		scree_world* world = open_world((float)-G);
		scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_WELD, NOBODY, body, 0.0f, 0.0f, 0.0f);
		def.coordinates[SCREE_ANGLE].lock_hertz = hertz[k % 4];
		def.coordinates[SCREE_ANGLE].lock_damping_ratio = k < 4 ? 0.0f : 1.0f;
		add_joint(world, &def);
		OK(scree_body_set_angular_velocity(world, body, 1.0f));
		run_steps(world, 60);
		NEAR(position_of(world, body).y, 0.0, 1e-3);
		NEAR(velocity_of(world, body).angular, 1.0, 1e-3);
		scree_world_destroy(world);
	}
}

// Limits hold against a motor and a spring of the same joint, even if these are very strong.
static void limits_hold_their_drives(void** state)
{
	(void)state;
	for (int k = 0; k < 12; ++k)
	{
		scree_world* world = open_world(0.0f);
		int turns = k & 1, spring = k & 2;
		scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.1f, turns ? 0.5f : 0.0f, 0.0f);
		scree_joint_def def =
		    joint_def_at(world, turns ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_PRISMATIC, NOBODY, body, 0.0f, 0.0f, 0.0f);
		scree_coordinate which = turns ? SCREE_ANGLE : SCREE_ALONG;
		scree_joint_coordinate* driven = &def.coordinates[which];
		driven->limited = true;
		driven->lower = -1.0f;
		driven->upper = 1.0f;
		driven->spring = spring != 0;
		driven->spring_hertz = k < 4 ? 10.0f : k < 8 ? 30.0f : 1000.0f;
		driven->spring_damping_ratio = 1.0f;
		driven->target = turns ? 2.0f : 5.0f;
		driven->motor = spring == 0;
		driven->motor_speed = 5.0f;
		driven->motor_max = k < 4 ? 100.0f : k < 8 ? 1e5f : 1e8f;
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 120);
		NEAR(joint_state_of(world, joint).values[which], 1.0, spring && turns ? 0.12 : 2e-3);
		NEAR(joint_state_of(world, joint).speeds[which], 0.0, 1e-3);
		scree_world_destroy(world);
	}
}

// A hinge at the end of a bar has a limit, and a spring of 10 or 30 Hz with a target 3 rad beyond the limit. A slider
// has such a spring with a target 10 m beyond its limit. The limit carries the whole force of the spring, so the locks
// hold as if there were neither spring nor limit. In an earlier version the hinge opened by 1.5 m, and the slider
// rotated by 0.05 rad.
static void limits_take_springs_from_locks(void** state)
{
	(void)state;
	for (int k = 0; k < 6; ++k)
	{
		scree_world* world = open_world((float)-G);
		int turns = k & 1, motor = k / 2 == 1;
		scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 3.0f, 0.2f, turns ? 3.0f : 0.0f, turns ? 0.0f : 1.0f);
		scree_joint_def def = joint_def_at(world, turns ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_PRISMATIC, NOBODY, body,
		                                   0.0f, 0.0f, turns ? 0.0f : 0.8f);
		scree_coordinate which = turns ? SCREE_ANGLE : SCREE_ALONG;
		scree_joint_coordinate* driven = &def.coordinates[which];
		driven->limited = driven->spring = true;
		driven->lower = -0.5f;
		driven->upper = 0.5f;
		driven->spring_hertz = k < 4 ? 30.0f : 10.0f;
		driven->spring_damping_ratio = k < 4 ? 0.5f : 0.0f;
		driven->target = turns ? 3.5f : 10.5f;
		driven->motor = motor;
		driven->motor_max = 10.0f;
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 120);
		scree_joint_state at = joint_state_of(world, joint);
		NEAR(at.values[which], 0.5, 1e-3);
		for (int c = 0; c < 3; ++c)
			if (c != (int)which && (c == SCREE_ACROSS || turns == (c == SCREE_ALONG)))
				NEAR(at.values[c], 0.0, 1e-3);
		scree_world_destroy(world);
	}
}

// A motor turns a bar 32 times. Then the motor is replaced by limits or a spring around the angle 0. The bar turns to
// this angle by the shorter rotation, at less than 31 rad/s, and the turns before are no longer counted. If the limits
// are around the current angle instead, which includes all turns, the bar stays in place.
static void turns_count_from_what_uses_them(void** state)
{
	(void)state;
	for (int k = 0; k < 3; ++k)
	{
		scree_world* world = open_world(0.0f);
		scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 2.0f, 0.2f, 2.0f, 0.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, NOBODY, body, 0.0f, 0.0f, 0.0f);
		scree_joint_coordinate* angle = &def.coordinates[SCREE_ANGLE];
		angle->motor = true;
		angle->motor_max = 1e4f;
		angle->motor_speed = 20.0f;
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 605);
		double turned = joint_state_of(world, joint).values[SCREE_ANGLE];
		NEAR(turned, 20.0 * 605.0 / 60.0, 0.5);
		angle->motor = false;
		angle->limited = k != 1;
		angle->spring = k == 1;
		angle->spring_hertz = 1.0f;
		angle->spring_damping_ratio = 1.0f;
		angle->lower = k == 2 ? (float)turned - 0.1f : -1.5f;
		angle->upper = k == 2 ? (float)turned + 2.0f : 0.2f;
		OK(scree_joint_set_coordinate(world, joint, SCREE_ANGLE, angle));
		for (int n = 0; n < 120; ++n)
		{
			run_steps(world, 1);
			scree_joint_state at = joint_state_of(world, joint);
			assert_true(fabs((double)at.speeds[SCREE_ANGLE]) < 31.0);
			NEAR(at.values[SCREE_ALONG], 0.0, 0.15);
		}
		double end = joint_state_of(world, joint).values[SCREE_ANGLE];
		assert_true(k == 2 ? end > turned - 0.11 && end < turned + 2.01 : end > -1.51 && end < 0.21);
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(limits_take_springs_from_locks),
	    cmocka_unit_test(turns_count_from_what_uses_them),
	    cmocka_unit_test(angles_count_turns),
	    cmocka_unit_test(wheels_turn_long),
	    cmocka_unit_test(sliders_stop),
	    cmocka_unit_test(ropes_are_slack),
	    cmocka_unit_test(targets_are_held),
	    cmocka_unit_test(soft_locks_have_a_direction),
	    cmocka_unit_test(joints_break_at_their_threshold),
	    cmocka_unit_test(torques_break),
	    cmocka_unit_test(drives_are_limited),
	    cmocka_unit_test(springs_of_nothing),
	    cmocka_unit_test(soft_locks_of_nothing),
	    cmocka_unit_test(limits_hold_their_drives),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
