// SPDX-License-Identifier: MIT
// test_sleep_supports.c -- checks that a change of a support wakes what rests on it, in the next step, and nothing else.
#include "support/make_joints.h"
#include "support/make_sleepers.h"

// Two stacks on two tables of 2 m at x = 0 and x = 10, whose surfaces are at y = 4. The floor is below.
typedef struct
{
	scree_world* world;
	scree_body bodies[STACK], other[STACK];
	scree_body table; // at x = 0
	scree_collidable part;
} Tables;

static Tables open_tables(scree_body_type type)
{
	Tables t = {.world = open_sleepers(-10.0f)};
	for (int k = 1; k >= 0; --k)
	{
		float x = 10.0f * (float)k;
		t.table = add_box(t.world, type, 1.0f, 0.5f, x, 3.5f);
		for (int i = 0; i < STACK; ++i)
			(k ? t.other : t.bodies)[i] = add_crate(t.world, SCREE_BODY_DYNAMIC, x, 4.5f + (float)i);
	}
	t.part = collidable_of(t.world, t.table);
	run_to_sleep(t.world, t.bodies, STACK);
	run_to_sleep(t.world, t.other, STACK);
	run_as_before(t.world, t.bodies, STACK, 20, false);
	return t;
}

// Returns the mean velocity of a stack along y, m/s. Forces between the crates do not change it.
static double rise_of(scree_world* world, const scree_body bodies[STACK])
{
	double sum = 0.0;
	for (int k = 0; k < STACK; ++k)
		sum += velocity_of(world, bodies[k]).linear.y;
	return sum / STACK;
}

// Takes the step after the change, which must wake the stack. Without a support, the stack falls in that step.
static void expect_woken(Tables* t, bool falls)
{
	run_steps(t->world, 1);
	expect_awake(t->world, t->bodies, STACK, true);
	if (falls)
		NEAR(rise_of(t->world, t->bodies), -G * STEP, 1e-5);
	run_as_before(t->world, t->bodies, STACK, 10, true);
	expect_awake(t->world, t->other, STACK, false);
	run_to_sleep(t->world, t->bodies, STACK);
	close_sleepers(t->world);
}

static void supports_are_destroyed(void** state)
{
	(void)state;
	Tables t = open_tables(SCREE_BODY_STATIC);
	OK(scree_body_destroy(t.world, t.table));
	expect_woken(&t, true);
	t = open_tables(SCREE_BODY_STATIC);
	OK(scree_collidable_destroy(t.world, t.part));
	expect_woken(&t, true);
	t = open_tables(SCREE_BODY_KINEMATIC);
	OK(scree_body_destroy(t.world, t.table));
	expect_woken(&t, true);
}

static void supports_are_disabled(void** state)
{
	(void)state;
	Tables t = open_tables(SCREE_BODY_STATIC);
	OK(scree_body_set_enabled(t.world, t.table, false));
	expect_woken(&t, true);
	t = open_tables(SCREE_BODY_STATIC);
	OK(scree_collidable_set_sensor(t.world, t.part, SCREE_SENSOR_MOVING));
	expect_woken(&t, true);
}

static void supports_are_filtered(void** state)
{
	(void)state;
	Tables t = open_tables(SCREE_BODY_STATIC);
	OK(scree_collidable_set_filter(t.world, t.part, (scree_filter){1, 0, 0}));
	expect_woken(&t, true);

	// the stack on the table is excluded from touching it; only the lowest crate touches it
	t = open_tables(SCREE_BODY_STATIC);
	OK(scree_body_set_excluded(t.world, t.table, t.bodies[0], true));
	expect_woken(&t, true);
}

static void supports_are_placed(void** state)
{
	(void)state;
	scree_pose lower = upright_at(0.0f, 2.0f), same = upright_at(0.0f, 3.5f);
	Tables t = open_tables(SCREE_BODY_STATIC);
	OK(scree_body_set_pose(t.world, t.table, lower));
	expect_woken(&t, true);
	t = open_tables(SCREE_BODY_KINEMATIC);
	OK(scree_body_set_pose(t.world, t.table, lower));
	expect_woken(&t, true);

	// a teleport to the same pose moves nothing
	t = open_tables(SCREE_BODY_STATIC);
	OK(scree_body_set_pose(t.world, t.table, same));
	run_as_before(t.world, t.bodies, STACK, 3, false);
	close_sleepers(t.world);
}

static void supports_begin_to_move(void** state)
{
	(void)state;
	Tables t = open_tables(SCREE_BODY_KINEMATIC);
	OK(scree_body_set_linear_velocity(t.world, t.table, (scree_vec){0.0f, 0.3f}));
	run_steps(t.world, 1);
	expect_awake(t.world, t.bodies, STACK, true);
	run_as_before(t.world, t.bodies, STACK, 59, true);
	NEAR(pose_of(t.world, t.bodies[STACK - 1]).position.y, 4.5 + STACK - 1 + 0.3, 0.02);
	OK(scree_body_set_linear_velocity(t.world, t.table, (scree_vec){0.0f, 0.0f}));
	expect_woken(&t, false);

	t = open_tables(SCREE_BODY_KINEMATIC);
	OK(scree_body_set_target(t.world, t.table, upright_at(0.01f, 3.5f)));
	expect_awake(t.world, t.bodies, STACK, false); // the target applies in the next step
	expect_woken(&t, false);
}

// Collidables without a body, and sensors, touch nothing: they come, move and go without an effect.
static void overlaps_wake_nothing(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK];
	add_stack(world, 0.0f, bodies);
	run_to_sleep(world, bodies, STACK);
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = box_attribute(world, 1.0f, 0.9f);
	def.pose = upright_at(0.5f, 1.0f);
	scree_collidable part = create_collidable(world, &def);
	run_as_before(world, bodies, STACK, 2, false);
	int overlaps;
	OK(scree_world_get_overlaps(world, NULL, 0, &overlaps));
	assert_int_equal(overlaps, 2); // the two lower crates
	def.pose = upright_at(50.0f, 1.0f);
	OK(scree_collidables_set_poses(world, &part, &def.pose, 1));
	run_as_before(world, bodies, STACK, 2, false);
	def.pose = upright_at(0.0f, 2.0f);
	OK(scree_collidables_set_poses(world, &part, &def.pose, 1));
	run_as_before(world, bodies, STACK, 2, false);
	OK(scree_collidable_destroy(world, part));
	run_as_before(world, bodies, STACK, 2, false);

	scree_body_def ghost = crate_def(world, SCREE_BODY_KINEMATIC, -2.0f, 1.0f);
	ghost.sensor = SCREE_SENSOR_MOVING;
	ghost.velocity.linear.x = 4.0f;
	create_body(world, &ghost);
	int visits = 0;
	for (int k = 0; k < 60; ++k)
	{
		run_as_before(world, bodies, STACK, 1, false);
		visits += events_of(world).visits_began_count - events_of(world).visits_ended_count;
		assert_true(visits >= 0 && visits <= 3);
	}
	assert_int_equal(visits, 0);
	close_sleepers(world);
}

static void sleepers_are_placed(void** state)
{
	(void)state;
	Tables t = open_tables(SCREE_BODY_STATIC);
	OK(scree_body_set_pose(t.world, t.bodies[STACK - 1], upright_at(0.0f, 20.0f)));
	expect_awake(t.world, t.bodies, STACK, true);
	run_steps(t.world, 1);
	NEAR(velocity_of(t.world, t.bodies[STACK - 1]).linear.y, -G * STEP, 1e-5);
	expect_awake(t.world, t.bodies, STACK, true);
	expect_awake(t.world, t.other, STACK, false);
	close_sleepers(t.world);

	// a crate is taken out in the step in which it fell asleep
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK];
	add_stack(world, 0.0f, bodies);
	while (is_awake(world, bodies[0]))
		run_steps(world, 1);
	OK(scree_body_set_pose(world, bodies[1], upright_at(10.0f, 0.5f)));
	run_steps(world, 1);
	expect_awake(world, bodies, STACK, true);
	NEAR(velocity_of(world, bodies[2]).linear.y, -G * STEP, 1e-5);
	run_to_sleep(world, bodies, STACK);
	NEAR(pose_of(world, bodies[STACK - 1]).position.y, STACK - 1.5, 0.02);
	close_sleepers(world);
}

// A change of a pair of materials, or of gravity, wakes the whole world.
static void worlds_wake(void** state)
{
	(void)state;
	Tables t = open_tables(SCREE_BODY_STATIC);
	scree_material_pair pair = scree_material_pair_default();
	pair.friction = 0.3f;
	OK(scree_world_set_material_pair(t.world, 3, 4, &pair));
	expect_awake(t.world, t.bodies, STACK, true);
	expect_awake(t.world, t.other, STACK, true);
	run_to_sleep(t.world, t.bodies, STACK);
	run_to_sleep(t.world, t.other, STACK);
	OK(scree_world_set_gravity(t.world, (scree_vec){0.0f, 5.0f}));
	run_steps(t.world, 1);
	expect_awake(t.world, t.bodies, STACK, true);
	double rise = rise_of(t.world, t.other);
	assert_in_range(rise * 1e6, 5e6 * STEP - 10, 5e6 * STEP + 2e5); // the table still pushes in the first step
	run_as_before(t.world, t.other, STACK, 30, true);
	NEAR(rise_of(t.world, t.other), rise + 5.0 * 30 * STEP, 0.05);
	close_sleepers(t.world);
}

static void lose_by_destroying(scree_world* world, scree_body support) { OK(scree_body_destroy(world, support)); }
static void lose_by_disabling(scree_world* world, scree_body support)
{
	OK(scree_body_set_enabled(world, support, false));
}
static void lose_by_filter(scree_world* world, scree_body support)
{
	OK(scree_collidable_set_filter(world, collidable_of(world, support), (scree_filter){.category = 1, .mask = 0}));
}
static void lose_by_moving(scree_world* world, scree_body support)
{
	OK(scree_body_set_pose(world, support, upright_at(50.0f, 0.5f)));
}
static void lose_by_gravity(scree_world* world, scree_body support)
{
	(void)support;
	OK(scree_world_set_gravity(world, (scree_vec){0.0f, 5.0f}));
}

// A crate at rest loses its support in any step before or after it falls asleep, also in a step that searches for
// islands. It never sleeps in the air: after a second it is where a crate is that cannot sleep.
static void bodies_do_not_sleep_in_the_air(void** state)
{
	(void)state;
	static void (*const loses[])(scree_world*, scree_body) = {lose_by_destroying, lose_by_disabling, lose_by_filter,
	                                                          lose_by_moving, lose_by_gravity};
	for (size_t how = 0; how < sizeof loses / sizeof *loses; ++how)
		for (int after = REST_STEPS - 2; after <= MOST_STEPS + 2; ++after)
		{
			scree_world* world = open_sleepers(-10.0f);
			scree_body support[2], top[2];
			for (int k = 0; k < 2; ++k)
			{
				support[k] = add_box(world, SCREE_BODY_STATIC, 0.5f, 0.5f, 4.0f * (float)k, 2.5f);
				top[k] = add_crate(world, SCREE_BODY_DYNAMIC, 4.0f * (float)k, 3.5f);
			}
			OK(scree_body_set_stays_awake(world, top[1], true));
			run_steps(world, after);
			for (int k = 0; k < 2; ++k)
				loses[how](world, support[k]);
			run_steps(world, 60);
			NEAR(pose_of(world, top[0]).position.y, pose_of(world, top[1]).position.y, 1e-3);
			scree_world_destroy(world);
		}
}

// A field on a body wakes sleepers in the place to which the user moves the body.
// A joint that was disabled while its body slept connects nothing, so its support may move.
static void disabled_joints_wake_nothing(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f),
	           support = add_crate(world, SCREE_BODY_KINEMATIC, 3.0f, 5.0f);
	scree_joint joint = join(world, SCREE_JOINT_DISTANCE, crate, support, 1.5f, 2.0f);
	run_to_sleep(world, &crate, 1);
	OK(scree_joint_set_enabled(world, joint, false));
	OK(scree_body_set_awake(world, crate, false));
	run_as_before(world, &crate, 1, 10, false);
	OK(scree_body_set_velocity(world, support, (scree_velocity){{1.0f, 0.0f}, 0.0f}));
	run_as_before(world, &crate, 1, 20, false);
	OK(scree_joint_set_enabled(world, joint, true));
	run_steps(world, 1);
	expect_awake(world, &crate, 1, true);
	close_sleepers(world);
}

static void placed_fields_wake(void** state)
{
	(void)state;
	for (int type = 0; type < 2; ++type)
	{
		scree_world* world = open_sleepers(-10.0f);
		scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
		scree_body carrier = add_box(world, type ? SCREE_BODY_KINEMATIC : SCREE_BODY_STATIC, 0.1f, 0.1f, -30.0f, 6.0f);
		scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
		def.body = carrier;
		def.shape = box_shape(1.0f, 8.0f);
		def.acceleration = (scree_vec){0.0f, 15.0f};
		OK(scree_field_create(world, &def, NULL));
		run_to_sleep(world, &crate, 1);
		OK(scree_body_set_pose(world, carrier, upright_at(0.0f, 6.0f)));
		run_steps(world, 30);
		assert_true(pose_of(world, crate).position.y > 0.8f);
		close_sleepers(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(supports_are_destroyed),
	    cmocka_unit_test(supports_are_disabled),
	    cmocka_unit_test(supports_are_filtered),
	    cmocka_unit_test(supports_are_placed),
	    cmocka_unit_test(supports_begin_to_move),
	    cmocka_unit_test(overlaps_wake_nothing),
	    cmocka_unit_test(sleepers_are_placed),
	    cmocka_unit_test(worlds_wake),
	    cmocka_unit_test(bodies_do_not_sleep_in_the_air),
	    cmocka_unit_test(disabled_joints_wake_nothing),
	    cmocka_unit_test(placed_fields_wake),
	};
	return RUN_SLEEPERS(tests);
}
