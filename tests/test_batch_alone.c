// SPDX-License-Identifier: MIT
// test_batch_alone.c -- checks that a world that was taken out of a batch goes on as the same world alone.
//
// Formula: hash and values of a world of scree_batch_extract = those of the world of the batch, and of the same world alone,
// after equal steps.
#include "support/batch_worlds.h"
#include "support/make_joints.h"

// A world that was taken out has the hashes of the world alone for hundreds of steps, also with other substeps.
static void worlds_go_on_alone(void** state)
{
	(void)state;
	static const char* const names[] = {"bridge", "ragdolls", "machine", "platforms", "cars", "shapes"};
	for (size_t k = 0; k < sizeof names / sizeof *names; ++k)
	{
		Scenario scenario = small_scene(names[k]);
		scree_world *world = scene_world(&scenario, 10), *taken[2];
		scree_batch_def def = scree_batch_def_default();
		scree_batch* batch;
		def.worlds = 3;
		def.templates = &world;
		def.template_count = 1;
		OK(scree_batch_create(&def, &batch));
		for (int step = 0; step < (quick() ? 60 : 300); ++step)
		{
			float dt = step == 150 ? 0.0f : scenario.dt;
			int substeps = scenario.substeps + (step % 100 < 10);
			if (step == 0 || step == 25)
				OK(scree_batch_extract(batch, 1, NULL, taken + (step != 0)));
			OK(scree_world_step(world, dt, substeps));
			OK(scree_batch_step(batch, dt, substeps, 1));
			for (int n = 0; n < 1 + (step >= 25); ++n)
			{
				OK(scree_world_step(taken[n], dt, substeps));
				if (hash_of(taken[n]) != hash_of(world))
					fail_msg("%s: world %d differs after step %d", names[k], n, step);
			}
		}
		uint64_t hashes[3];
		OK(scree_batch_get_hashes(batch, hashes));
		assert_true(hashes[2] == hash_of(world));
		OK(scree_batch_reset(batch, (const uint8_t[]){1, 0, 0}));
		OK(scree_batch_insert(batch, 0, taken[1]));
		OK(scree_batch_get_hashes(batch, hashes));
		assert_true(hashes[0] == hash_of(world));
		scree_batch_destroy(batch);
		scree_world_destroy(world);
		scree_world_destroy(taken[0]);
		scree_world_destroy(taken[1]);
		scene_free((Scene*)scenario.context);
	}
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// Handles of the template are valid in a world that was taken out, and its values are those of the world alone.
static void handles_stay_valid(void** state)
{
	(void)state;
	scree_world *world = open_awake(-10.0f), *taken;
	scree_body_def ground = crate_def(world, SCREE_BODY_STATIC, 0.0f, -1.0f),
	               box = crate_def(world, SCREE_BODY_DYNAMIC, 0.2f, 1.0f);
	scree_body bodies[2];
	OK(scree_body_create(world, &ground, bodies));
	OK(scree_body_create(world, &box, bodies + 1));
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 50));
	for (int step = 0; step < 50; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	OK(scree_batch_extract(batch, 0, NULL, &taken));
	scree_contact contacts[2][4];
	int counts[2];
	OK(scree_world_get_contacts(world, contacts[0], 4, counts));
	OK(scree_world_get_contacts(taken, contacts[1], 4, counts + 1));
	assert_int_equal(counts[0], counts[1]);
	assert_true(counts[0] > 0);
	assert_memory_equal(contacts[0], contacts[1], sizeof *contacts[0] * (size_t)counts[0]);
	scree_pose poses[2];
	OK(scree_body_get_pose(world, bodies[1], poses));
	OK(scree_body_get_pose(taken, bodies[1], poses + 1));
	assert_memory_equal(poses, poses + 1, sizeof *poses);

	// a push of the world alone goes back into the batch
	scree_velocity velocity = {{3.0f, 2.0f}, 1.0f};
	OK(scree_body_set_velocity(taken, bodies[1], velocity));
	OK(scree_body_set_velocity(world, bodies[1], velocity));
	OK(scree_batch_insert(batch, 0, taken));
	for (int step = 0; step < 30; ++step)
	{
		uint64_t hash;
		OK(scree_batch_get_hashes(batch, &hash));
		assert_true(hash == hash_of(world) && hash == hash_of(taken));
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		OK(scree_world_step(world, STEP, SUBSTEPS));
		OK(scree_world_step(taken, STEP, SUBSTEPS));
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	scree_world_destroy(taken);
	assert_int_equal(scree_memory(), 0);
}

// The inputs of a world stay in its state: a world that was taken out has its motor speed, on the host too.
static void inputs_stay(void** state)
{
	(void)state;
	scree_world *world = open_awake(-10.0f), *taken;
	scree_body body;
	scree_body_def box = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 2.0f);
	OK(scree_body_create(world, &box, &body));
	scree_joint_def joint = joint_def_at(world, SCREE_JOINT_REVOLUTE, NOBODY, body, 0.0f, 2.0f, 0.0f), now;
	joint.coordinates[SCREE_ANGLE].motor = true;
	joint.coordinates[SCREE_ANGLE].motor_max = 50.0f;
	scree_joint wheel = add_joint(world, &joint);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.worlds = 2;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	scree_channel speed = scree_channel_make(SCREE_INPUT_MOTOR_SPEED);
	float speeds[2] = {3.0f, -2.0f};
	speed.joint = wheel;
	speed.which = SCREE_ANGLE;
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &speed, 1, speeds));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 20));
	OK(scree_batch_extract(batch, 1, NULL, &taken));
	OK(scree_joint_get_def(taken, wheel, &now));
	assert_true(now.coordinates[SCREE_ANGLE].motor_speed == -2.0f && now.coordinates[SCREE_ANGLE].motor_max == 50.0f);
	uint64_t hashes[2];
	OK(scree_batch_get_hashes(batch, hashes));
	assert_true(hashes[1] == hash_of(taken) && hashes[0] != hashes[1]);
	OK(scree_batch_insert(batch, 0, taken));
	speeds[0] = speeds[1];
	for (int step = 0; step < 20; ++step)
	{
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		OK(scree_world_step(taken, STEP, SUBSTEPS));
		OK(scree_batch_get_hashes(batch, hashes));
		assert_true(hashes[0] == hash_of(taken) && hashes[1] == hashes[0]);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	scree_world_destroy(taken);
	assert_int_equal(scree_memory(), 0);
}

// The number of steps of a world that was taken out is that of the world alone: of its template, and of its own steps, also
// after pauses, resets, steps of length 0 and loads.
static void steps_are_counted(void** state)
{
	(void)state;
	enum
	{
		WORLDS = 4
	};
	scree_world *world = falling_boxes(3), *taken;
	scree_body added;
	for (int step = 0; step < 7; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	scree_body_def box = crate_def(world, SCREE_BODY_DYNAMIC, 4.0f, 3.0f); // newer than the last step of the template
	OK(scree_body_create(world, &box, &added));
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	int64_t steps[WORLDS] = {7, 7, 7, 7}, kept = 0;
	random_state = 8;
	def.worlds = WORLDS;
	def.templates = &world;
	def.template_count = 1;
	def.threads = 1;
	OK(scree_batch_create(&def, &batch));
	size_t bytes = scree_batch_get_state_bytes(batch) * 4; // the bays may grow
	char* row = malloc(bytes);
	for (int step = 0; step < 40; ++step)
	{
		uint8_t paused[WORLDS], reset[WORLDS];
		for (int k = 0; k < WORLDS; ++k)
		{
			reset[k] = step > 0 && random_below(12) == 0;
			paused[k] = random_below(4) == 0;
			steps[k] = (reset[k] ? 7 : steps[k]) + (step > 0 && !paused[k]);
		}
		OK(scree_batch_reset(batch, reset));
		OK(scree_batch_pause(batch, paused));
		OK(scree_batch_step(batch, step % 10 == 9 ? 0.0f : STEP, SUBSTEPS, step > 0));
		const int32_t from = random_below(WORLDS), to = random_below(WORLDS);
		if (step % 3 == 0 && kept > 0)
		{
			OK(scree_batch_load(batch, &to, 1, row, bytes));
			steps[to] = kept;
		}
		if (step % 4 == 0)
		{
			OK(scree_batch_save(batch, &from, 1, row, bytes));
			kept = steps[from];
		}
		for (int k = 0; k < WORLDS; ++k)
		{
			scree_counters counters;
			OK(scree_batch_extract(batch, k, NULL, &taken));
			OK(scree_world_get_counters(taken, &counters));
			if (counters.steps != steps[k])
				fail_msg("world %d after step %d: %lld steps, expected %lld", k, step, (long long)counters.steps,
				         (long long)steps[k]);
			OK(scree_batch_insert(batch, k, taken));
			scree_world_destroy(taken);
		}
	}
	free(row);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(worlds_go_on_alone),
	    cmocka_unit_test(handles_stay_valid),
	    cmocka_unit_test(inputs_stay),
	    cmocka_unit_test(steps_are_counted),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
