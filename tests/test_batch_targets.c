// SPDX-License-Identifier: MIT
// test_batch_targets.c -- checks worlds of a batch whose templates have pending targets, or masses for which chains end or begin.
//
// Formula: hash(world in a batch, age) = hash(same world alone, age), also before the first step, to which these changes belong;
// after resets, pauses, inputs that replace targets, and states that are loaded or taken out.
#include "support/batch_run.h"
#include "support/make_joints.h"

static scree_body lifts[3]; // kinematic bodies of the last world of open_lifts; the last one is disabled

// Opens a world of two lifts with a ball on each, after some steps. targets: bit k sets the target of lift k.
static scree_world* open_lifts(int steps, int targets)
{
	scree_world* world = open_awake(-10.0f);
	add_crate(world, SCREE_BODY_STATIC, 9.0f, 0.0f);
	for (int k = 0; k < 3; ++k)
	{
		lifts[k] = add_box(world, SCREE_BODY_KINEMATIC, 1.0f, 0.2f, 3.0f * (float)k, 0.0f);
		add_disc(world, 0.2f, 3.0f * (float)k + 0.3f, 0.4f);
	}
	OK(scree_body_set_locks(world, lifts[1], SCREE_LOCK_X));
	OK(scree_body_set_enabled(world, lifts[2], false));
	for (int step = 0; step < steps; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	for (int k = 2; k >= 0; --k)
		if (targets >> k & 1)
			OK(scree_body_set_target(world, lifts[k], pose_at(3.0f * (float)k + 0.05f, 0.06f, 0.02f * (float)k)));
	return world;
}

static scree_batch* open_copies(scree_world* world, int worlds)
{
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.worlds = worlds;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	return batch;
}

static void check_world(scree_batch* batch, int k, scree_world* alone, const char* name)
{
	uint64_t hashes[MOST_WORLDS];
	OK(scree_batch_get_hashes(batch, hashes));
	if (hashes[k] != hash_of(alone))
		fail_msg("%s: world %d differs from the world alone", name, k);
}

// Opens a world with a chain of links from the ground, which ends in its next step, and one that begins in it.
static scree_world* open_chains(int steps)
{
	scree_world* world = open_awake(-10.0f);
	scree_body links[2][5];
	for (int chain = 0; chain < 2; ++chain)
	{
		scree_body before = SCREE_NULL_BODY;
		for (int k = 0; k < 5; ++k)
		{
			float x = (float)k + 20.0f * (float)chain;
			links[chain][k] = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.3f, x, 0.0f);
			join(world, SCREE_JOINT_REVOLUTE, before, links[chain][k], x - 0.5f, 0.0f);
			before = links[chain][k];
		}
	}
	OK(scree_body_set_mass(world, links[0][4], (scree_mass){500.0f, 50.0f, {0.0f, 0.0f}}));
	for (int step = 0; step < steps; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	OK(scree_body_set_mass(world, links[0][4], (scree_mass){1.0f, 0.1f, {0.0f, 0.0f}}));
	OK(scree_body_set_mass(world, links[1][4], (scree_mass){500.0f, 50.0f, {0.0f, 0.0f}}));
	return world;
}

// Compares worlds of 5 templates with worlds alone, at several places. open: opens template k.
static void check_templates(scree_world* (*open)(int k), const char* name)
{
	const Place places[] = {{"cpu", MOST_WORLDS, 1, 1}, {"cpu", 25, 2, 4}, {"cpu", 9, 1, 0}, {second_device, 11, 0, 0}};
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
	{
		Templates t = {.count = 5, .dt = STEP, .substeps = SUBSTEPS};
		if (!places[k].device[0])
			continue;
		for (int n = 0; n < t.count; ++n)
			t.worlds[n] = open(n);
		BatchRun r = {.t = &t, .worlds = places[k].worlds};
		random_state = (uint32_t)(k + 1);
		r.batch = open_batch(&t, places + k, r.template_of);
		record_alone(&t);
		run_at_random(&r, k == 3 ? 20 : 100, name);
		close_templates(&t);
	}
	assert_int_equal(scree_memory(), 0);
}

static scree_world* open_lift(int k)
{
	static const int steps[] = {0, 0, 20, 5, 5}, targets[] = {7, 0, 3, 2, 0};
	return k < 4 ? open_lifts(steps[k], targets[k]) : falling_boxes(5);
}

static scree_world* open_chain(int k)
{
	static const int steps[] = {0, 1, 20, 3, 5};
	return k < 4 ? open_chains(steps[k]) : falling_boxes(5);
}

static void worlds_are_equal(void** state)
{
	(void)state;
	check_templates(open_lift, "targets");
	check_templates(open_chain, "chains");
}

// A batch, or a world of it, that is made from a world leaves the world as it is.
static void worlds_stay(void** state)
{
	(void)state;
	scree_world *world = open_chain(2), *other = open_chain(3), *alone[2] = {clone_of(world), clone_of(other)};
	uint64_t hash = hash_of(world);
	scree_batch* batch = open_copies(world, 2);
	check_world(batch, 1, world, "new batch");
	assert_true(hash_of(world) == hash);
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	hash = hash_of(other);
	OK(scree_batch_insert(batch, 1, other));
	check_world(batch, 1, other, "inserted world");
	assert_true(hash_of(other) == hash);
	scree_body bodies[10];
	int count;
	OK(scree_world_get_bodies(world, bodies, 10, &count));
	for (int k = 0; k < 2; ++k)
	{
		scree_world* given = k == 0 ? world : other;
		OK(scree_body_set_mass(given, bodies[4], (scree_mass){500.0f, 50.0f, {0.0f, 0.0f}}));
		OK(scree_body_set_mass(alone[k], bodies[4], (scree_mass){500.0f, 50.0f, {0.0f, 0.0f}}));
		OK(scree_world_step(given, STEP, SUBSTEPS));
		OK(scree_world_step(alone[k], STEP, SUBSTEPS));
		assert_true(hash_of(given) == hash_of(alone[k]));
		scree_world_destroy(given);
		scree_world_destroy(alone[k]);
	}
	scree_batch_destroy(batch);
	assert_int_equal(scree_memory(), 0);
}

// A step with dt 0 reaches no target.
static void targets_stay_without_motion(void** state)
{
	(void)state;
	scree_world* world = open_lifts(3, 3);
	scree_batch* batch = open_copies(world, 2);
	static const float lengths[] = {0.0f, 0.0f, STEP, 0.0f, STEP / 2};
	for (int k = 0; k < 5; ++k)
	{
		check_world(batch, k % 2, world, "dt 0");
		OK(scree_batch_step(batch, lengths[k], SUBSTEPS, 1));
		OK(scree_world_step(world, lengths[k], SUBSTEPS));
	}
	check_world(batch, 0, world, "dt 0");
	NEAR(pose_of(world, lifts[0]).position.x, 0.05, 1e-7);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// A target or a velocity among the inputs replaces the target of the template; a pose does not. list: where the input is.
static void check_input(scree_channel_kind kind, scree_channels list)
{
	scree_world *world = open_lifts(3, 3), *alone = clone_of(world);
	scree_batch* batch = open_copies(world, 3);
	scree_channel input = scree_channel_make(kind);
	input.body = lifts[0];
	OK(scree_batch_bind(batch, list, &input, 1, NULL));
	float* rows = scree_batch_get_rows(batch, list);
	int columns = scree_batch_get_columns(batch, list);
	for (int k = 0; k < 3; ++k)
	{
		rows[k * columns] = 0.1f;
		rows[k * columns + 1] = 0.02f;
		rows[k * columns + 2] = kind == SCREE_INPUT_VELOCITY ? 0.3f : 1.0f;
	}
	scree_velocity velocity = {{0.1f, 0.02f}, 0.3f};
	scree_pose pose = {{0.1f, 0.02f}, {1.0f, 0.0f}};
	for (int step = 0; step < 6; ++step)
	{
		bool acts = list == SCREE_RESET_INPUTS ? step == 0 || step == 3 : true;
		if (step == 0 || step == 3)
		{
			OK(scree_batch_reset(batch, NULL));
			scree_world_destroy(alone);
			alone = clone_of(world);
		}
		if (acts && kind == SCREE_INPUT_VELOCITY)
			OK(scree_body_set_velocity(alone, lifts[0], velocity));
		if (acts && kind == SCREE_INPUT_POSE)
			OK(scree_body_set_pose(alone, lifts[0], pose));
		if (acts && kind == SCREE_INPUT_TARGET)
			OK(scree_body_set_target(alone, lifts[0], pose));
		if (list == SCREE_RESET_INPUTS)
			check_world(batch, step % 3, alone, "inputs of a reset");
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		OK(scree_world_step(alone, STEP, SUBSTEPS));
		check_world(batch, step % 3, alone, "inputs");
	}
	scree_batch_destroy(batch);
	scree_world_destroy(alone);
	scree_world_destroy(world);
}

static void inputs_replace_targets(void** state)
{
	(void)state;
	check_input(SCREE_INPUT_VELOCITY, SCREE_STEP_INPUTS);
	check_input(SCREE_INPUT_VELOCITY, SCREE_RESET_INPUTS);
	check_input(SCREE_INPUT_POSE, SCREE_STEP_INPUTS);
	check_input(SCREE_INPUT_POSE, SCREE_RESET_INPUTS);
	check_input(SCREE_INPUT_TARGET, SCREE_STEP_INPUTS);
	assert_int_equal(scree_memory(), 0);
}

// A target among the inputs has no effect in a step with dt 0, or on a disabled body, and a later velocity of the list cancels it.
static void targets_need_motion(void** state)
{
	(void)state;
	static const float lengths[] = {0.0f, STEP, 0.0f, STEP};
	const float row[] = {0.0f, 0.1f, 0.02f, 1.0f, 0.0f, 0.0f, 0.5f, 0.0f};
	for (int cancels = 0; cancels < 2; ++cancels)
	{
		scree_world *world = open_lifts(3, 3), *alone[2] = {clone_of(world), clone_of(world)};
		scree_batch* batch = open_copies(world, 2);
		scree_channel inputs[3] = {scree_channel_make(SCREE_INPUT_ENABLED), scree_channel_make(SCREE_INPUT_TARGET),
		                           scree_channel_make(SCREE_INPUT_VELOCITY)};
		for (int k = 0; k < 3; ++k)
			inputs[k].body = lifts[0];
		OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, inputs, 2 + cancels, NULL));
		float* rows = scree_batch_get_rows(batch, SCREE_STEP_INPUTS);
		for (int k = 0; k < 4; ++k)
		{
			for (int world_number = 0; world_number < 2; ++world_number)
			{
				memcpy(rows + world_number * (5 + 3 * cancels), row, sizeof(float) * (size_t)(5 + 3 * cancels));
				rows[world_number * (5 + 3 * cancels)] = (float)world_number;
				OK(scree_body_set_enabled(alone[world_number], lifts[0], world_number == 1));
			}
			if (lengths[k] > 0.0f)
				OK(scree_body_set_target(alone[1], lifts[0], pose_at(0.1f, 0.02f, 0.0f)));
			for (int n = 0; n < 2 && cancels; ++n)
				OK(scree_body_set_velocity(alone[n], lifts[0], (scree_velocity){{0.0f, 0.5f}, 0.0f}));
			OK(scree_batch_step(batch, lengths[k], SUBSTEPS, 1));
			for (int n = 0; n < 2; ++n)
			{
				OK(scree_world_step(alone[n], lengths[k], SUBSTEPS));
				check_world(batch, n, alone[n], cancels ? "a cancelled target" : "a target that is not reached");
			}
		}
		scree_batch_destroy(batch);
		for (int n = 0; n < 2; ++n)
			scree_world_destroy(alone[n]);
		scree_world_destroy(world);
	}
	assert_int_equal(scree_memory(), 0);
}

// States with targets that the template lacks are refused, and so are more targets than a set has bits.
static void other_targets_are_refused(void** state)
{
	(void)state;
	scree_world *world = open_lifts(0, 1), *other = open_lifts(0, 2), *none = open_lifts(0, 0);
	scree_batch *batch = open_copies(world, 1), *batch2 = open_copies(other, 1);
	const int32_t first = 0;
	size_t bytes = scree_batch_get_state_bytes(batch);
	char* row = malloc(bytes);
	REFUSED(scree_batch_insert(batch, 0, other),
	        "scree_batch_insert: from has pending targets that the template of world 0 lacks");
	OK(scree_batch_save(batch, &first, 1, row, bytes));
	REFUSED(scree_batch_load(batch2, &first, 1, row, 0),
	        "scree_batch_load: state 0 has pending targets that the template of world 0 lacks");
	OK(scree_batch_insert(batch, 0, none)); // the lift rests, as in the world alone
	check_world(batch, 0, none, "none");
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	OK(scree_world_step(none, STEP, SUBSTEPS));
	check_world(batch, 0, none, "none");
	bytes = scree_batch_get_state_bytes(batch); // the world has got contacts
	free(row);
	row = malloc(bytes);
	OK(scree_batch_save(batch, &first, 1, row, bytes));
	OK(scree_batch_load(batch2, &first, 1, row, 0));
	check_world(batch2, 0, none, "none");
	scree_batch_destroy(batch);
	scree_batch_destroy(batch2);
	for (int k = 0; k < 64; ++k)
	{
		scree_body body = add_box(world, SCREE_BODY_KINEMATIC, 0.1f, 0.1f, 20.0f + (float)k, 0.0f);
		OK(scree_body_set_target(world, body, upright_at(20.5f + (float)k, 0.0f)));
	}
	scree_batch_def def = scree_batch_def_default();
	def.templates = &world;
	def.template_count = 1;
	REFUSED(scree_batch_create(&def, &batch),
	        "scree_batch_create: template 0 has 65 pending targets, must have at most 64");
	OK(scree_body_set_velocity(world, lifts[0], (scree_velocity){{0.0f, 0.0f}, 0.0f}));
	batch = open_copies(world, 2);
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	OK(scree_world_step(world, STEP, SUBSTEPS));
	check_world(batch, 1, world, "64 targets");
	scree_batch_destroy(batch);
	free(row);
	scree_world_destroy(world);
	scree_world_destroy(other);
	scree_world_destroy(none);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(worlds_are_equal),
	    cmocka_unit_test(worlds_stay),
	    cmocka_unit_test(targets_stay_without_motion),
	    cmocka_unit_test(inputs_replace_targets),
	    cmocka_unit_test(targets_need_motion),
	    cmocka_unit_test(other_targets_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
