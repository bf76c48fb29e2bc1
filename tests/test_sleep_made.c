// SPDX-License-Identifier: MIT
// test_sleep_made.c -- checks bodies that are created asleep, and calls that must not wake bodies.
#include "support/make_joints.h"
#include "support/make_sleepers.h"

// Bodies that are created asleep in the air stay there, without the velocity of their definition.
static void expect_hanging(scree_world* world, const scree_body* bodies, int count, float x, float dx)
{
	expect_awake(world, bodies, count, false);
	run_as_before(world, bodies, count, 60, false);
	for (int k = 0; k < count; ++k)
	{
		expect_pose(world, bodies[k], upright_at(x + dx * (float)k, 5.0f));
		expect_velocity(world, bodies[k], 0, 0, 0);
	}
}

static void bodies_are_created_asleep(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body_def defs[40];
	scree_body bodies[40];
	for (int k = 0; k < 40; ++k)
	{
		defs[k] = crate_def(world, SCREE_BODY_DYNAMIC, 2.0f * (float)k, 5.0f);
		defs[k].velocity = (scree_velocity){{1, 2}, 3};
		defs[k].asleep = true;
	}
	bodies[0] = create_body(world, &defs[0]); // few bodies are sent by commands, 16 or more by rows
	OK(scree_bodies_create(world, defs + 1, 39, bodies + 1));
	expect_hanging(world, bodies, 40, 0.0f, 2.0f);
	OK(scree_body_set_awake(world, bodies[7], true));
	run_steps(world, 1);
	NEAR(velocity_of(world, bodies[7]).linear.y, -G * STEP, 1e-6);
	assert_int_equal(counters_of(world).asleep_bodies, 39);
	close_sleepers(world);
}

// Collidables and joints that are added in the same interval between two steps leave the bodies asleep. Later ones wake
// them.
static void parts_are_added(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[10];
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 5.0f);
	scree_collidable_def part = scree_collidable_def_default();
	part.attribute = box_attribute(world, 0.2f, 0.2f);
	part.pose = upright_at(0.0f, 0.6f);
	def.asleep = true;
	for (int k = 0; k < 10; ++k)
	{
		def.pose.position.x = 1.5f * (float)k;
		bodies[k] = part.body = create_body(world, &def);
		create_collidable(world, &part);
		if (k > 0)
			join(world, SCREE_JOINT_REVOLUTE, bodies[k - 1], bodies[k], 1.5f * (float)k - 0.75f, 5.0f);
	}
	// the pose of the origin is kept to rounding, because the second collidable moves the center of mass
	scree_pose poses[10];
	run_steps(world, 1);
	for (int k = 0; k < 10; ++k)
	{
		poses[k] = pose_of(world, bodies[k]);
		NEAR(poses[k].position.y, 5.0, 1e-6);
	}
	run_as_before(world, bodies, 10, 60, false);
	for (int k = 0; k < 10; ++k)
		expect_pose(world, bodies[k], poses[k]);

	// the joints make one island
	OK(scree_body_set_awake(world, bodies[0], true));
	expect_awake(world, bodies, 10, true);
	run_steps(world, 1);
	for (int k = 0; k < 10; ++k)
		assert_true(velocity_of(world, bodies[k]).linear.y < -0.9f * (float)G * STEP);
	close_sleepers(world);
}

// A body that is created asleep in the slot of another body is not woken by the contacts of the other.
static void slots_are_used_again(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	run_steps(world, 10);
	assert_int_equal(contacts_with(world, body), 1);
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 20.0f, 5.0f);
	def.asleep = true;
	OK(scree_body_destroy(world, body));
	scree_body next = create_body(world, &def);
	assert_int_equal(next.index, body.index);
	expect_hanging(world, &next, 1, 20.0f, 0.0f);
	close_sleepers(world);
}

// A body that is created asleep and touches an awake one wakes.
static void touches_wake_new_bodies(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 1.5f);
	def.asleep = true;
	scree_body body = create_body(world, &def);
	assert_false(is_awake(world, body));
	run_steps(world, 1);
	assert_true(is_awake(world, body));

	// a definition that forbids sleep, or a world without sleep, creates awake bodies
	def.pose.position.x = 10.0f;
	def.stays_awake = true;
	assert_true(is_awake(world, create_body(world, &def)));
	def.stays_awake = false;
	def.pose.position.x = 20.0f;
	def.type = SCREE_BODY_KINEMATIC;
	assert_true(is_awake(world, create_body(world, &def)));
	close_sleepers(world);
}

// Bodies that are created asleep wake if sleep is turned off before the next step.
static void sleep_is_turned_off(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 5.0f);
	def.asleep = true;
	scree_body body = create_body(world, &def);
	scree_tuning tuning;
	OK(scree_world_get_tuning(world, &tuning));
	tuning.sleep = false;
	OK(scree_world_set_tuning(world, &tuning));
	assert_true(is_awake(world, body));
	run_steps(world, 1);
	NEAR(velocity_of(world, body).linear.y, -G * STEP, 1e-6);
	close_sleepers(world);
}

static void read_all(scree_world* world, scree_body body)
{
	scree_contact contacts[32];
	scree_render_row rows[32];
	scree_body_state states[32];
	scree_moved_bodies moved;
	scree_query_results list;
	scree_body_def def;
	int count;
	OK(scree_world_get_contacts(world, contacts, 32, &count));
	OK(scree_body_get_contacts(world, body, contacts, 32, &count));
	OK(scree_world_get_render_rows(world, rows, 32, &count));
	OK(scree_world_get_states(world, NULL, states, 32, &count));
	OK(scree_world_get_moved_bodies(world, &moved));
	OK(scree_world_overlap_box(world, (scree_box){{-2, -2}, {2, 5}}, &list));
	assert_int_equal(list.count, STACK + 1);
	OK(scree_body_get_def(world, body, &def));
	NEAR(mass_of(world, body).mass, 1.0, 1e-6);
	assert_int_equal(counters_of(world).asleep_bodies, STACK);
}

static void reads_and_zeros_wake_nothing(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK];
	scree_vec none = {0, 0}, at = {1, 2};
	add_stack(world, 0.0f, bodies);
	run_to_sleep(world, bodies, STACK);
	scree_pose top = pose_of(world, bodies[STACK - 1]);
	for (int k = 0; k < 10; ++k)
	{
		scree_body body = bodies[k % STACK];
		read_all(world, body);
		OK(scree_body_apply_force(world, body, none));
		OK(scree_body_apply_force_at(world, body, none, at));
		OK(scree_body_apply_torque(world, body, 0.0f));
		OK(scree_body_apply_impulse(world, body, none));
		OK(scree_body_apply_impulse_at(world, body, none, at));
		OK(scree_body_apply_angular_impulse(world, body, -0.0f));
		OK(scree_body_set_velocity(world, body, (scree_velocity){{0, 0}, 0}));
		OK(scree_body_set_linear_velocity(world, body, none));
		OK(scree_body_set_angular_velocity(world, body, 0.0f));
		OK(scree_world_set_gravity(world, (scree_vec){0, -10}));
		OK(scree_body_set_user(world, body, 7));
		add_crate(world, SCREE_BODY_STATIC, 50.0f + 2.0f * (float)k, 0.5f); // far away
		run_as_before(world, bodies, STACK, 2, false);
	}
	for (int k = 0; k < STACK; ++k)
		expect_velocity(world, bodies[k], 0, 0, 0);
	expect_pose(world, bodies[STACK - 1], top);
	close_sleepers(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(bodies_are_created_asleep),    cmocka_unit_test(parts_are_added),
	    cmocka_unit_test(slots_are_used_again),         cmocka_unit_test(touches_wake_new_bodies),
	    cmocka_unit_test(reads_and_zeros_wake_nothing), cmocka_unit_test(sleep_is_turned_off),
	};
	return RUN_SLEEPERS(tests);
}
