// SPDX-License-Identifier: MIT
// test_sleep_pushes.c -- checks that each call that changes a body or a joint wakes the island, and that joints drag
// sleeping bodies.
#include "support/make_fields.h"
#include "support/make_joints.h"
#include "support/make_sleepers.h"

typedef void (*Push)(scree_world* world, scree_body body);

static void force(scree_world* w, scree_body b) { OK(scree_body_apply_force(w, b, (scree_vec){1e-3f, 0})); }
static void force_at(scree_world* w, scree_body b)
{
	OK(scree_body_apply_force_at(w, b, (scree_vec){0, 1}, (scree_vec){0, 0}));
}
static void torque(scree_world* w, scree_body b) { OK(scree_body_apply_torque(w, b, -1e-3f)); }
static void impulse(scree_world* w, scree_body b) { OK(scree_body_apply_impulse(w, b, (scree_vec){0, 1e-6f})); }
static void impulse_at(scree_world* w, scree_body b)
{
	OK(scree_body_apply_impulse_at(w, b, (scree_vec){1, 0}, (scree_vec){0, 1}));
}
static void spin_impulse(scree_world* w, scree_body b) { OK(scree_body_apply_angular_impulse(w, b, 1e-6f)); }
static void velocity(scree_world* w, scree_body b)
{
	OK(scree_body_set_velocity(w, b, (scree_velocity){{0, 0}, 1e-6f}));
}
static void linear(scree_world* w, scree_body b) { OK(scree_body_set_linear_velocity(w, b, (scree_vec){1e-6f, 0})); }
static void spin(scree_world* w, scree_body b) { OK(scree_body_set_angular_velocity(w, b, -1.0f)); }
static void pose(scree_world* w, scree_body b) { OK(scree_body_set_pose(w, b, pose_of(w, b))); }
static void mass(scree_world* w, scree_body b) { OK(scree_body_set_mass(w, b, (scree_mass){2, 1, {0, 0}})); }
static void type(scree_world* w, scree_body b) { OK(scree_body_set_type(w, b, SCREE_BODY_KINEMATIC)); }
static void damping(scree_world* w, scree_body b) { OK(scree_body_set_damping(w, b, 1.0f, 2.0f)); }
static void gravity_scale(scree_world* w, scree_body b) { OK(scree_body_set_gravity_scale(w, b, -1.0f)); }
static void locks(scree_world* w, scree_body b) { OK(scree_body_set_locks(w, b, SCREE_LOCK_X)); }
static void disable(scree_world* w, scree_body b) { OK(scree_body_set_enabled(w, b, false)); }
static void destroy(scree_world* w, scree_body b) { OK(scree_body_destroy(w, b)); }
static void remove_part(scree_world* w, scree_body b) { OK(scree_collidable_destroy(w, collidable_of(w, b))); }
static void dress(scree_world* w, scree_body b)
{
	OK(scree_collidable_set_attribute(w, collidable_of(w, b), box_attribute(w, 0.4f, 0.4f)));
}
static void filter(scree_world* w, scree_body b)
{
	OK(scree_collidable_set_filter(w, collidable_of(w, b), (scree_filter){1, 1, 1}));
}
static void join_world(scree_world* w, scree_body b) { join(w, SCREE_JOINT_WELD, NOBODY, b, 0.0f, 1.5f); }

static void rub(scree_world* w, scree_body b)
{
	scree_attribute_def def = surface_of(box_shape(0.5f, 0.5f));
	def.friction = 0.1f;
	OK(scree_collidable_set_attribute(w, collidable_of(w, b), add_attribute(w, &def)));
}

static void add_part(scree_world* w, scree_body b)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = box_attribute(w, 0.1f, 0.1f);
	def.body = b;
	create_collidable(w, &def);
}

static void changes_wake_islands(void** state)
{
	(void)state;
	const Push pushes[] = {force,   force_at,    torque, impulse, impulse_at, spin_impulse,  velocity,  linear,
	                       spin,    pose,        mass,   type,    damping,    gravity_scale, locks,     disable,
	                       destroy, remove_part, dress,  filter,  rub,        add_part,      join_world};
	for (size_t k = 0; k < sizeof pushes / sizeof pushes[0]; ++k)
	{
		scree_world* world = open_sleepers(-10.0f);
		scree_body bodies[STACK], other[STACK];
		add_stack(world, 0.0f, bodies);
		add_stack(world, 10.0f, other);
		run_to_sleep(world, bodies, STACK);
		run_to_sleep(world, other, STACK);
		pushes[k](world, bodies[1]);
		for (int step = 0; step < 2; ++step) // the bodies count as awake at once
		{
			for (int i = 0; i < STACK; ++i)
				if (i != 1 && !is_awake(world, bodies[i]))
					fail_msg("change %d does not wake body %d", (int)k, i);
			run_steps(world, 1);
		}
		expect_awake(world, other, STACK, false);
		close_sleepers(world);
	}
}

// Two discs hang side by side without gravity, 3 m apart, joined by a rod.
static void joints_drag_sleepers(void** state)
{
	(void)state;
	for (int how = 0; how < 4; ++how)
	{
		scree_world* world = open_sleepers(0.0f);
		scree_body puller =
		    add_shape(world, how < 3 ? SCREE_BODY_KINEMATIC : SCREE_BODY_DYNAMIC, circle_shape(0.5f), 0, 0, 0);
		scree_body pulled = add_disc(world, 0.5f, 3.0f, 0.0f), far = add_disc(world, 0.5f, 3.0f, 9.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_WELD, puller, pulled, 1.5f, 0.0f, 0.0f);
		scree_joint joint = add_joint(world, &def);
		run_to_sleep(world, &pulled, 1);
		run_as_before(world, &pulled, 1, 20, false);
		assert_int_equal(joint_state_of(world, joint).broken, 0);
		if (how == 0)
			OK(scree_body_set_linear_velocity(world, puller, (scree_vec){-0.6f, 0.0f}));
		else if (how == 1)
			OK(scree_body_set_target(world, puller, upright_at(-0.01f, 0.0f)));
		else if (how == 2)
			OK(scree_body_set_pose(world, puller, upright_at(-0.01f, 0.0f)));
		else
			OK(scree_body_apply_impulse(world, puller, (scree_vec){-2.0f * 0.6f * mass_of(world, puller).mass, 0.0f}));
		run_steps(world, 1);
		assert_true(is_awake(world, pulled));
		assert_true(velocity_of(world, pulled).linear.x < -0.05f || pose_of(world, pulled).position.x < 2.995f);
		run_steps(world, 4);
		assert_true(is_awake(world, pulled) && !is_awake(world, far));
		double way = how == 0 || how == 3 ? -0.6 * 5 * STEP : -0.01;
		NEAR(pose_of(world, pulled).position.x, 3.0 + way, 0.004);
		close_sleepers(world);
	}
}

// Changes of a joint wake both bodies; a setting with its present value does not.
static void changes_of_joints_wake_bodies(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(0.0f);
	scree_body bodies[2] = {add_disc(world, 0.5f, 0.0f, 0.0f), add_disc(world, 0.5f, 3.0f, 0.0f)};
	scree_joint joint = join(world, SCREE_JOINT_PRISMATIC, bodies[0], bodies[1], 1.5f, 0.0f);
	scree_joint_coordinate motor;
	OK(scree_joint_get_coordinate(world, joint, SCREE_ALONG, &motor));
	motor.motor = true;
	motor.motor_max = 100.0f;
	run_to_sleep(world, bodies, 2);
	OK(scree_joint_set_coordinate(world, joint, SCREE_ALONG, &motor));
	expect_awake(world, bodies, 2, true);
	run_to_sleep(world, bodies, 2);
	OK(scree_joint_set_coordinate(world, joint, SCREE_ALONG, &motor));
	OK(scree_joint_set_motor_speed(world, joint, SCREE_ALONG, 0.0f));
	run_as_before(world, bodies, 2, 3, false);
	OK(scree_joint_set_motor_speed(world, joint, SCREE_ALONG, 1.0f));
	run_as_before(world, bodies, 2, 60, true); // the motor keeps its bodies awake
	NEAR(velocity_of(world, bodies[1]).linear.x - velocity_of(world, bodies[0]).linear.x, 1.0, 1e-3);
	OK(scree_joint_set_motor_speed(world, joint, SCREE_ALONG, 0.0f));
	run_to_sleep(world, bodies, 2);
	OK(scree_joint_set_enabled(world, joint, false));
	expect_awake(world, bodies, 2, true);
	run_to_sleep(world, bodies, 2);
	OK(scree_body_set_awake(world, bodies[0], true));
	assert_false(is_awake(world, bodies[1])); // a disabled joint connects nothing
	run_to_sleep(world, bodies, 2);
	OK(scree_joint_destroy(world, joint));
	expect_awake(world, bodies, 2, true);
	close_sleepers(world);
}

static scree_joint soft_joint; // joint of the body of settings_in_each_step with the world

static void set_same(scree_world* world, scree_body body)
{
	scree_tuning tuning;
	scree_vec gravity;
	scree_filter filter;
	scree_collidable part = collidable_of(world, body);
	scree_attribute attribute;
	scree_material_pair pair = scree_material_pair_default();
	pair.friction = 0.3f;
	OK(scree_world_get_tuning(world, &tuning));
	OK(scree_world_set_tuning(world, &tuning));
	OK(scree_world_get_gravity(world, &gravity));
	OK(scree_world_set_gravity(world, gravity));
	OK(scree_world_set_material_pair(world, 1, 2, &pair));
	OK(scree_body_set_damping(world, body, 0.5f, 0.25f));
	OK(scree_body_set_gravity_scale(world, body, 0.75f));
	OK(scree_body_set_locks(world, body, SCREE_LOCK_X));
	OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
	OK(scree_body_set_enabled(world, body, true));
	OK(scree_collidable_get_filter(world, part, &filter));
	OK(scree_collidable_set_filter(world, part, filter));
	OK(scree_collidable_get_attribute(world, part, &attribute));
	OK(scree_collidable_set_attribute(world, part, attribute));
	OK(scree_joint_set_stiffness(world, soft_joint, 5.0f, 2.0f));
	OK(scree_joint_set_thresholds(world, soft_joint, 100.0f, 200.0f, true));
	OK(scree_joint_set_frames(world, soft_joint, upright_at(0.0f, 0.5f), upright_at(0.0f, 0.0f)));
	OK(scree_joint_set_enabled(world, soft_joint, true));
	OK(scree_joint_set_collide_connected(world, soft_joint, true));
}

// A program may set the same settings before each step: they wake nothing, and a body falls asleep in spite of them.
static void settings_in_each_step(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_WELD, NOBODY, body, 0.0f, 0.5f, 0.0f);
	soft_joint = add_joint(world, &def);
	for (int k = 0; k < MOST_STEPS + 20; ++k)
	{
		set_same(world, body);
		run_steps(world, 1);
	}
	assert_false(is_awake(world, body));
	close_sleepers(world);
}

// A field beyond the range of boxes can be created, changed and destroyed.
static void fields_far_away(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_WIND);
	OK(scree_shape_make_circle((scree_vec){3.0f, 0.0f}, 1.0f, &def.shape));
	def.pose.position.x = SCREE_MAX_COORDINATE;
	scree_field field = add_field(world, &def);
	def.strength = 5.0f;
	OK(scree_field_set_def(world, field, &def));
	OK(scree_field_set_enabled(world, field, false));
	OK(scree_field_destroy(world, field));
	close_sleepers(world);
}

// A target stands through steps with dt 0, in which the groups of its body come to rest. The body then moves as it would without
// these steps, and strikes what it reaches.
static void targets_outlast_pauses(void** state)
{
	(void)state;
	static const int pauses[] = {0, 16, 17, 100}; // steps with dt 0: two searches of islands end with step 17
	uint64_t hashes[4];
	for (int k = 0; k < 4; ++k)
	{
		scree_world* world = open_sleepers(0.0f);
		scree_body ram = add_shape(world, SCREE_BODY_KINEMATIC, box_shape(0.5f, 0.5f), 0, 0, 0);
		scree_body disc = add_disc(world, 0.5f, 1.5f, 0.0f);
		run_to_sleep(world, &disc, 1);
		run_steps(world, 3 * MOST_STEPS);
		OK(scree_body_set_target(world, ram, upright_at(1.0f, 0.0f)));
		for (int n = 0; n < pauses[k]; ++n)
			OK(scree_world_step(world, 0.0f, 4));
		run_steps(world, 20);
		assert_true(pose_of(world, disc).position.x > 2.0f);
		hashes[k] = hash_of(world);
		assert_true(hashes[k] == hashes[0]);
		close_sleepers(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(changes_wake_islands),
	                                   cmocka_unit_test(joints_drag_sleepers),
	                                   cmocka_unit_test(changes_of_joints_wake_bodies),
	                                   cmocka_unit_test(settings_in_each_step),
	                                   cmocka_unit_test(fields_far_away),
	                                   cmocka_unit_test(targets_outlast_pauses)};
	return RUN_SLEEPERS(tests);
}
