// SPDX-License-Identifier: MIT
// test_batch_sleep.c -- checks worlds of a batch whose bodies fall asleep and wake.
//
// Formula: after any sequence of steps, resets, pauses, inputs and copies, hash(world in a batch) = hash(the same world alone
// after the same calls). The hash of a world that sleeps contains islands, times at rest and marks.
#include "support/batch_twins.h"
#include "support/make_joints.h"
#include "support/make_sleepers.h"

// ---------------------------------------------------------------------------------------------------------------
// levels
// ---------------------------------------------------------------------------------------------------------------

// Two stacks, and a disc that rolls against them after some seconds.
static void build_stacks(scree_world* world)
{
	scree_body bodies[STACK];
	add_floor(world);
	add_stack(world, 0.0f, bodies);
	add_stack(world, 3.0f, bodies);
	throw_body(world, add_disc(world, 0.5f, -9.0f, 0.5f), 3.0f, 0.0f, -6.0f);
}

// A weight on a rope of joints that is damped, a door with a spring, and crates side by side.
static void build_rope(scree_world* world)
{
	scree_body before = NOBODY;
	add_floor(world);
	for (int k = 0; k < 5; ++k)
	{
		scree_body_def def =
		    body_def(SCREE_BODY_DYNAMIC, box_attribute(world, 0.25f, 0.05f), 0.25f + 0.5f * (float)k, 6.0f);
		def.linear_damping = def.angular_damping = 3.0f;
		def.locks = k == 4 ? SCREE_LOCK_ROTATION : 0;
		scree_body link = create_body(world, &def);
		join(world, SCREE_JOINT_REVOLUTE, before, link, 0.5f * (float)k, 6.0f);
		before = link;
	}
	for (int k = 0; k < 3; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 6.0f + 1.5f * (float)k, 0.5f);
}

// A kinematic cart that carries a crate toward sleeping ones.
static void build_cart(scree_world* world)
{
	add_floor(world);
	throw_body(world, add_box(world, SCREE_BODY_KINEMATIC, 1.0f, 0.2f, -6.0f, 0.21f), 1.5f, 0.0f, 0.0f);
	add_crate(world, SCREE_BODY_DYNAMIC, -6.0f, 0.92f);
	for (int k = 0; k < 3; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 2.0f + 1.01f * (float)k, 0.5f);
	add_crate(world, SCREE_BODY_DYNAMIC, 12.0f, 0.5f);
}

// Bodies that were created asleep, some of them with joints, below a crate that falls on them.
static void build_made_asleep(scree_world* world)
{
	add_floor(world);
	scree_body last = NOBODY;
	for (int k = 0; k < 6; ++k)
	{
		scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 1.01f * (float)k, 0.5f);
		def.asleep = true;
		def.locks = k == 2 ? SCREE_LOCK_X : 0;
		last = create_body(world, &def);
	}
	join(world, SCREE_JOINT_REVOLUTE, last, add_crate(world, SCREE_BODY_DYNAMIC, 7.0f, 0.5f), 6.5f, 0.5f);
	add_crate(world, SCREE_BODY_DYNAMIC, 3.0f, 9.0f);
}

// A weight between spokes, which is a hub, on a frozen slope of discs.
static void build_hub(scree_world* world)
{
	add_floor(world);
	for (int k = 0; k < 40; ++k)
		add_disc(world, 0.1f, 0.21f * (float)k, 0.1f);
	add_box(world, SCREE_BODY_DYNAMIC, 4.2f, 0.2f, 4.1f, 0.41f);
}

// A world with another sleep threshold, in which one body has its own.
static void build_lively(scree_world* world)
{
	scree_tuning tuning;
	OK(scree_world_get_tuning(world, &tuning));
	tuning.sleep_threshold = 1.0f;
	OK(scree_world_set_tuning(world, &tuning));
	build_rope(world);
	OK(scree_body_set_sleep_threshold(world, add_crate(world, SCREE_BODY_DYNAMIC, 15.0f, 3.0f), 0.002f));
}

static scree_body some_body(scree_world* world, int number)
{
	scree_body bodies[64];
	int count;
	OK(scree_world_get_bodies(world, bodies, 64, &count));
	assert_true(count > number);
	return bodies[number];
}

// Calls without a step behind them: the next step puts a body to sleep, and wakes another one.
static void leave_marks(scree_world* world)
{
	OK(scree_body_set_awake(world, some_body(world, 2), false));
	OK(scree_body_apply_impulse(world, some_body(world, 5), (scree_vec){0.0f, 3.0f}));
}

static const Level levels[] = {
    {.build = build_stacks, .sleeps = true},
    {.build = build_stacks, .sleeps = true, .steps = 75, .dt = STEP, .substeps = 4},
    {.build = build_stacks, .sleeps = true, .steps = 77, .dt = STEP, .substeps = 4, .end = leave_marks},
    {.build = build_rope, .sleeps = true, .steps = 3, .dt = STEP, .substeps = 4},
    {.build = build_rope, .sleeps = true, .steps = 230, .dt = STEP, .substeps = 2},
    {.build = build_cart, .sleeps = true, .steps = 53, .dt = STEP, .substeps = 4},
    {.build = build_made_asleep, .sleeps = true},
    {.build = build_stacks, .steps = 20, .dt = STEP, .substeps = 4},
    {.build = build_lively, .sleeps = true, .steps = 60, .dt = STEP, .substeps = 4},
    {.build = build_hub, .sleeps = true, .steps = 12, .dt = STEP, .substeps = 4},
};

// Most changes of gravity wake all bodies of a world, so few of them leave time to fall asleep.
static void worlds_fall_asleep(void** state)
{
	(void)state;
	check_levels(levels, COUNT_OF(levels), COUNT_OF(levels) + 4, 260, 30, false);
}

static void changes_wake_worlds(void** state)
{
	(void)state;
	check_levels(levels, COUNT_OF(levels), 2 * COUNT_OF(levels), 120, 5, true);
}

// A crate that stands still rests one step longer after each step, until it sleeps; an impulse wakes it, and its rest is 0.
static void rest_is_measured(void** state)
{
	(void)state;
	scree_world_def world_def = scree_world_def_default();
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	world_def.device = "cpu";
	scree_world* world = create_world(&world_def);
	scree_channel outputs[2] = {scree_channel_make(SCREE_OUTPUT_REST), scree_channel_make(SCREE_OUTPUT_REST)};
	scree_channel input = scree_channel_make(SCREE_INPUT_IMPULSE);
	float rests[3][2], impulses[3][2] = {{0.0f}}, expected = 0.0f;
	outputs[1].body = add_floor(world);
	outputs[0].body = input.body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	def.worlds = 3;
	def.templates = &world;
	def.template_count = 1;
	def.device = "cpu";
	OK(scree_batch_create(&def, &batch));
	REFUSED(scree_batch_bind(batch, SCREE_OUTPUTS, outputs, 2, rests[0]),
	        "scree_batch_bind: channels[1] is the rest of a body that is not dynamic (template 0)");
	outputs[1].body = outputs[0].body;
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, outputs, 2, rests[0]));
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &input, 1, impulses[0]));
	for (int step = 0; step < 60; ++step)
	{
		impulses[1][0] = step == 50 ? 9.0f : 0.0f;
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		for (int w = 0; w < 3; ++w)
			assert_true(rests[w][0] == rests[w][1] && rests[w][0] >= 0.0f);
		assert_true(rests[0][0] == rests[2][0]);
		assert_true(step < 40 || rests[0][0] >= 0.5f);
		assert_true(step < 2 || step > 20 || rests[0][0] == expected + STEP);
		assert_true(step != 50 || rests[1][0] == 0.0f);
		expected = rests[0][0];
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(worlds_fall_asleep),
	    cmocka_unit_test(changes_wake_worlds),
	    cmocka_unit_test(rest_is_measured),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
