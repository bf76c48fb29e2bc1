// SPDX-License-Identifier: MIT
// test_batch_tunings.c -- checks batches whose templates have different tunings.
//
// Formula: hash(world in a batch, age) = hash(same world alone, age), for templates of several tunings in any order; rows of
// masks, gravity, inputs, outputs, hashes and counters belong to the worlds of their numbers.
#include "support/batch_run.h"
#include <math.h>

#define TUNINGS 6

// Opens a world of bouncing and stacked bodies, with tuning k. The first and the last tuning are equal.
static scree_world* open_tuned(int k)
{
	scree_world* world = open_awake(-10.0f);
	scree_tuning tuning;
	OK(scree_world_get_tuning(world, &tuning));
	tuning.contact_hertz = k == 1 ? 12.0f : tuning.contact_hertz;
	tuning.contact_damping_ratio = k == 2 ? 1.5f : tuning.contact_damping_ratio;
	tuning.contact_push_speed = k == 2 ? 0.4f : tuning.contact_push_speed;
	tuning.restitution_threshold = k == 3 ? 6.0f : tuning.restitution_threshold;
	tuning.max_speed = k == 4 ? 3.0f : tuning.max_speed;
	OK(scree_world_set_tuning(world, &tuning));
	scree_attribute ball = add_surface(world, circle_shape(0.3f), 0.4f, 0.9f);
	add_body(world, SCREE_BODY_DYNAMIC, ball, 0.1f, 2.0f, 0.0f);
	add_floor(world);
	for (int n = 0; n < 4; ++n)
		add_crate(world, SCREE_BODY_DYNAMIC, 3.0f + 0.1f * (float)n, 0.4f + 0.9f * (float)n);
	return world;
}

static Templates open_tunings(void)
{
	Templates t = {.count = TUNINGS, .dt = STEP, .substeps = SUBSTEPS};
	for (int k = 0; k < TUNINGS; ++k)
		t.worlds[k] = open_tuned(k);
	return t;
}

static void worlds_are_equal(void** state)
{
	(void)state;
	const Place places[] = {
	    {"cpu", MOST_WORLDS, 1, 1}, {"cpu", 27, 2, 4}, {"cpu", 12, 1, 0}, {second_device, 12, 0, 0}};
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
	{
		if (!places[k].device[0])
			continue;
		Templates t = open_tunings();
		BatchRun r = {.t = &t, .worlds = places[k].worlds};
		random_state = (uint32_t)(k + 1);
		r.batch = open_batch(&t, places + k, r.template_of);
		record_alone(&t);
		for (int n = 1; n < TUNINGS - 1; ++n) // the tunings matter
			assert_true(t.hashes[n][AGES] != t.hashes[0][AGES]);
		run_at_random(&r, k == 3 ? 15 : 100, "tunings");
		close_templates(&t);
	}
	assert_int_equal(scree_memory(), 0);
}

static scree_body first_body(const scree_world* world)
{
	scree_body bodies[8];
	int count;
	OK(scree_world_get_bodies(world, bodies, 8, &count));
	return bodies[0];
}

// Gravity, inputs, outputs and counters of a world, with other ones for each, are those of the world alone.
static void rows_belong_to_worlds(const char* device)
{
	enum
	{
		WORLDS = 11
	};
	Templates t = open_tunings();
	Place place = {device, WORLDS, 2, 0};
	int template_of[WORLDS];
	scree_world* alone[WORLDS];
	scree_vec gravity[WORLDS];
	random_state = 5;
	scree_batch* batch = open_batch(&t, &place, template_of);
	scree_channel force = scree_channel_make(SCREE_INPUT_FORCE), start = scree_channel_make(SCREE_INPUT_VELOCITY),
	              pose = scree_channel_make(SCREE_OUTPUT_POSE);
	scree_body body = first_body(t.worlds[0]); // all templates have the same handles
	force.body = start.body = pose.body = body;
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &force, 1, NULL));
	OK(scree_batch_bind(batch, SCREE_RESET_INPUTS, &start, 1, NULL));
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, &pose, 1, NULL));
	float *forces = scree_batch_get_rows(batch, SCREE_STEP_INPUTS),
	      *starts = scree_batch_get_rows(batch, SCREE_RESET_INPUTS),
	      *poses = scree_batch_get_rows(batch, SCREE_OUTPUTS);
	for (int k = 0; k < WORLDS; ++k)
	{
		alone[k] = clone_of(t.worlds[template_of[k]]);
		gravity[k] = (scree_vec){0.1f * (float)k, -10.0f + (float)(k % 3)};
		starts[3 * k] = 0.2f * (float)k;
		starts[3 * k + 1] = 1.0f;
		OK(scree_world_set_gravity(alone[k], gravity[k]));
		OK(scree_body_set_velocity(alone[k], body, (scree_velocity){{starts[3 * k], 1.0f}, 0.0f}));
	}
	OK(scree_batch_set_gravity(batch, gravity));
	OK(scree_batch_reset(batch, NULL));
	for (int step = 0; step < 30; ++step)
	{
		uint64_t hashes[WORLDS];
		scree_batch_counters counters[WORLDS];
		for (int k = 0; k < WORLDS; ++k)
		{
			forces[2 * k] = 0.3f * (float)(k - step % 4);
			OK(scree_body_apply_force(alone[k], body, (scree_vec){forces[2 * k], 0.0f}));
			OK(scree_world_step(alone[k], STEP, SUBSTEPS));
		}
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		OK(scree_batch_get_hashes(batch, hashes));
		OK(scree_batch_get_counters(batch, counters));
		for (int k = 0; k < WORLDS; ++k)
		{
			scree_counters now;
			scree_pose at = pose_of(alone[k], body);
			OK(scree_world_get_counters(alone[k], &now));
			assert_true(hashes[k] == hash_of(alone[k]));
			assert_int_equal(counters[k].contacts, now.contacts);
			assert_memory_equal(&counters[k].penetration, &now.penetration, sizeof now.penetration);
			assert_memory_equal(&at, poses + 4 * k, sizeof at);
		}
	}
	forces[2 * 7 + 1] = INFINITY;
	assert_int_equal(scree_batch_step(batch, STEP, SUBSTEPS, 1), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "world 7"));
	for (int k = 0; k < WORLDS; ++k)
		scree_world_destroy(alone[k]);
	scree_batch_destroy(batch);
	close_templates(&t);
}

static void rows_are_not_mixed(void** state)
{
	(void)state;
	rows_belong_to_worlds("cpu");
	if (second_device[0])
		rows_belong_to_worlds(second_device);
	assert_int_equal(scree_memory(), 0);
}

// States go between worlds of the same tuning only.
static void other_tunings_are_refused(void** state)
{
	(void)state;
	Templates t = open_tunings();
	const int template_of[] = {4, 0, 1, 5};
	const int32_t worlds[] = {0, 1, 3};
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.worlds = 4;
	def.templates = t.worlds;
	def.template_count = t.count;
	def.template_of = template_of;
	OK(scree_batch_create(&def, &batch));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 20));
	size_t bytes = scree_batch_get_state_bytes(batch);
	char* rows = malloc(3 * bytes);
	OK(scree_batch_save(batch, worlds, 3, rows, bytes));
	OK(scree_batch_load(batch, worlds + 2, 1, rows + bytes, 0)); // equal tuning and structure
	REFUSED(
	    scree_batch_load(batch, worlds + 1, 1, rows, 0),
	    "scree_batch_load: state 0 is that of a world with another structure or other settings than the template of "
	    "world 1");
	REFUSED(scree_batch_insert(batch, 2, t.worlds[0]), "scree_batch_insert: from has other settings, or other shapes, "
	                                                   "densities, joints or rules, than the template of "
	                                                   "world 2");
	free(rows);
	scree_batch_destroy(batch);
	close_templates(&t);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(worlds_are_equal),
	    cmocka_unit_test(rows_are_not_mixed),
	    cmocka_unit_test(other_tunings_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
