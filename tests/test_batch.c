// SPDX-License-Identifier: MIT
// test_batch.c -- checks that each world of a batch has the bits that it has alone.
//
// Formula: hash(world in a batch, age) = hash(same world alone, age), for each template, number of worlds, place in the
// batch, device, number of threads and lanes, after resets of any worlds at any time. age: steps since the last reset.
#include "support/batch_worlds.h"

// Steps a batch, resets random worlds, and compares all worlds with their templates, which record_alone has stepped.
static void check_batch(scree_batch* batch, const Templates* t, const int* template_of, int steps, const char* name)
{
	int worlds = scree_batch_get_worlds(batch);
	int* ages = calloc((size_t)worlds, sizeof *ages);
	uint8_t* mask = malloc((size_t)worlds);
	for (int step = 0; step < steps; ++step)
	{
		int resets = 0;
		for (int k = 0; k < worlds; ++k)
		{
			mask[k] = ages[k] == AGES || random_below(12) == 0;
			ages[k] = mask[k] ? 0 : ages[k];
			resets += mask[k];
		}
		if (resets > 0)
			OK(scree_batch_reset(batch, mask));
		if (step % 5 == 0)
			check_hashes(batch, t, template_of, ages, name);
		OK(scree_batch_step(batch, t->dt, t->substeps, 1));
		for (int k = 0; k < worlds; ++k)
			++ages[k];
		if (step % 5 < 2)
			check_hashes(batch, t, template_of, ages, name);
	}
	free(ages);
	free(mask);
}

static void scene_equals(const Scenario* scenario)
{
	Templates t = {.dt = scenario->dt, .substeps = scenario->substeps};
	const Place places[] = {{"cpu", 6, 1, 0}, {"cpu", 3, 2, 1}, {second_device, 4, 0, 0}};
	int template_of[3][8];
	for (int first = 0; first <= 25; first += 25) // with joints that have not begun; in motion
	{
		open_scene_templates(&t, scenario, first);
		int used = second_device[0] ? 3 : 2;
		scree_batch* batches[3];
		random_state = (uint32_t)first + 7;
		for (int k = 0; k < used; ++k)
			batches[k] = open_batch(&t, places + k, template_of[k]);
		record_alone(&t);
		for (int k = 0; k < used; ++k)
		{
			check_batch(batches[k], &t, template_of[k], k == 2 || quick() ? 16 : 60, scenario->name);
			scree_batch_destroy(batches[k]);
		}
		close_templates(&t);
	}
}

static void scenes_are_equal(void** state)
{
	(void)state;
	for_every_scene(scene_equals);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// Worlds of different scenes in one batch: flags that some need change no bit of others, whose bays are larger than needed.
static void templates_are_mixed(void** state)
{
	static const char* const names[] = {"bridge",  "cars",     "chains",   "dominoes",   "gears",
	                                    "machine", "ragdolls", "shapes",   "slope",      "tumbler",
	                                    "washer",  "windmill", "pyramids", "alarm-clock"};
	(void)state;
	Templates t = {.dt = STEP, .substeps = SUBSTEPS};
	Scenario scenarios[MOST_TEMPLATES];
	for (; t.count < (int)(sizeof names / sizeof *names); ++t.count)
	{
		scenarios[t.count] = small_scene(names[t.count]);
		t.worlds[t.count] = scene_world(scenarios + t.count, 20);
	}
	const Place places[] = {{"cpu", 41, 1, 0}, {"cpu", 90, 2, 4}, {second_device, 30, 0, 0}};
	scree_batch* batches[3] = {NULL};
	int template_of[3][90];
	for (int k = 0; k < 3; ++k)
		if (places[k].device[0])
			batches[k] = open_batch(&t, places + k, template_of[k]);
	record_alone(&t);
	for (int k = 0; k < 3; ++k)
	{
		if (batches[k])
			check_batch(batches[k], &t, template_of[k], k == 2 ? 20 : 60, "mixed");
		scree_batch_destroy(batches[k]);
	}
	close_templates(&t);
	for (size_t k = 0; k < sizeof names / sizeof *names; ++k)
		scene_free((Scene*)scenarios[k].context);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// Bays whose contact slots are too few grow in the middle of a step, and nothing is lost.
static void bays_grow(void** state)
{
	(void)state;
	for (int device = 0; device < 2 && (device == 0 || second_device[0]); ++device)
	{
		Templates t = {.count = 2, .dt = STEP, .substeps = SUBSTEPS};
		int template_of[70];
		t.worlds[0] = falling_boxes(24);
		t.worlds[1] = falling_boxes(3);
		Place place = {device ? second_device : "cpu", 70, 2, 0};
		scree_batch* batch = open_batch(&t, &place, template_of);
		record_alone(&t);
		check_batch(batch, &t, template_of, AGES, "growth");
		scree_batch_destroy(batch);
		close_templates(&t);
	}
	assert_int_equal(scree_memory(), 0);
}

// A world has the same bits at every place of batches of every size, and in many steps of one call.
static void places_do_not_matter(void** state)
{
	(void)state;
	static const int sizes[] = {1, 2, 3, 8, 64, 129, 400};
	Templates t = {.count = 1, .dt = STEP, .substeps = SUBSTEPS};
	scree_batch* batches[sizeof sizes / sizeof *sizes];
	int template_of[400], ages[400];
	t.worlds[0] = falling_boxes(6);
	for (size_t k = 0; k < sizeof sizes / sizeof *sizes; ++k)
		batches[k] = open_batch(&t, &(Place){"cpu", sizes[k], 1 + (int)k % 2, k % 3 == 2 ? 1 : 0}, template_of);
	record_alone(&t);
	memset(template_of, 0, sizeof template_of);
	for (size_t k = 0; k < sizeof sizes / sizeof *sizes; ++k)
	{
		OK(scree_batch_step(batches[k], t.dt, t.substeps, AGES));
		for (int w = 0; w < sizes[k]; ++w)
			ages[w] = AGES;
		check_hashes(batches[k], &t, template_of, ages, "places");
		OK(scree_batch_reset(batches[k], NULL));
		memset(ages, 0, sizeof ages);
		check_hashes(batches[k], &t, template_of, ages, "places");
		OK(scree_batch_step(batches[k], t.dt, t.substeps, 0));
		check_hashes(batches[k], &t, template_of, ages, "places");
		scree_batch_destroy(batches[k]);
	}
	close_templates(&t);
	assert_int_equal(scree_memory(), 0);
}

// Steps of other lengths, and of 0 s, have the bits that they have in a world alone.
static void lengths_may_change(void** state)
{
	(void)state;
	static const float lengths[] = {STEP, 0.0f, STEP / 2, STEP / 2, 0.0f, STEP, STEP / 3};
	Scenario scenario = small_scene("ragdolls");
	scree_world* world = scene_world(&scenario, 15);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	uint64_t hashes[5];
	def.worlds = 5;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	for (size_t k = 0; k < 3 * sizeof lengths / sizeof *lengths; ++k)
	{
		float dt = lengths[k % (sizeof lengths / sizeof *lengths)];
		OK(scree_batch_step(batch, dt, 1 + (int)k % 5, 1));
		OK(scree_world_step(world, dt, 1 + (int)k % 5));
		OK(scree_batch_get_hashes(batch, hashes));
		for (int w = 0; w < 5; ++w)
			if (hashes[w] != hash_of(world))
				fail_msg("world %d differs after step %d", w, (int)k);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	scene_free((Scene*)scenario.context);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// Visits to a destroyed sensor are in the hash of a world until its next step, so they are refused.
static void visits_are_refused(void** state)
{
	(void)state;
	scree_world* world = open_awake(-10.0f);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	scree_body gate, visitor = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_body_def gate_def = crate_def(world, SCREE_BODY_STATIC, 0.0f, 0.0f);
	gate_def.sensor = SCREE_SENSOR_MOVING;
	OK(scree_body_create(world, &gate_def, &gate));
	OK(scree_world_step(world, STEP, SUBSTEPS));
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	scree_batch_destroy(batch);
	OK(scree_body_destroy(world, gate));
	REFUSED(scree_batch_create(&def, &batch),
	        "scree_batch_create: template 0 has visits to a collidable that is no longer a sensor, which worlds of a "
	        "batch cannot have yet");
	OK(scree_world_step(world, STEP, SUBSTEPS));
	OK(scree_batch_create(&def, &batch));
	scree_batch_destroy(batch);
	assert_true(scree_body_is_valid(world, visitor));
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// Contacts that need approval wait for answers of the program, also after the last such collidable was destroyed.
static void approvals_are_refused(void** state)
{
	(void)state;
	const char* sentence =
	    "scree_batch_create: template 0 has, or had, contacts that need approval (SCREE_REPORT_APPROVAL), "
	    "which worlds of a batch cannot have, because the program would have to answer for each world "
	    "after each step";
	scree_world* world = open_awake(-10.0f);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	scree_body guest = add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_APPROVAL, 0.0f, 0.0f);
	def.templates = &world;
	def.template_count = 1;
	REFUSED(scree_batch_create(&def, &batch), sentence);
	OK(scree_body_destroy(world, guest));
	OK(scree_world_step(world, STEP, SUBSTEPS));
	REFUSED(scree_batch_create(&def, &batch), sentence);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// The stages of a step are measured on each device, and only if the definition says so.
static void stages_are_measured(void** state)
{
	(void)state;
	scree_world* world = falling_boxes(3);
	for (int k = 0; k < 4; ++k)
	{
		scree_batch* batch;
		scree_timings times;
		scree_batch_def def = scree_batch_def_default();
		def.device = k < 2 ? "cpu" : second_device;
		def.worlds = 300;
		def.templates = &world;
		def.template_count = 1;
		def.timings = k % 2 == 1;
		if (!def.device[0])
			continue;
		OK(scree_batch_create(&def, &batch));
		OK(scree_batch_get_timings(batch, &times));
		assert_true(times.step == 0.0f && times.solve == 0.0f && times.finalize == 0.0f);
		OK(scree_batch_step(batch, STEP, 4, 2));
		OK(scree_batch_get_timings(batch, &times));
		const float stages[] = {times.transform, times.broad_phase, times.narrow_phase,
		                        times.color,     times.solve,       times.finalize};
		for (int n = 0; n < 6; ++n)
			if (!(def.timings ? stages[n] >= 0.0f && stages[n] < 1.0e4f : stages[n] == 0.0f))
				fail_msg("%s, timings %d: stage %d took %g ms", def.device, def.timings, n, (double)stages[n]);
		assert_true((times.step > 0.0f && times.solve > 0.0f) == def.timings && times.queries == 0.0f);
		REFUSED(scree_batch_get_timings(batch, NULL), "scree_batch_get_timings: timings is null");
		scree_batch_destroy(batch);
	}
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

static void bad_arguments_are_refused(void** state)
{
	(void)state;
	scree_world *world = falling_boxes(1), *sleeper = open_world(-10.0f);
	scree_batch* batch = NULL;
	scree_batch_def def = scree_batch_def_default();
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.template_count is 0, must be at least 1");
	def.template_count = 1;
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.templates is null");
	def.templates = &world;
	def.worlds = 0;
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.worlds is 0, must be from 1 to 16777216");
	def.worlds = 3;
	def.template_of = (const int[]){0, 0, 1};
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.template_of[2] is 1, must be from 0 to 0");
	def.template_of = NULL;
	def.device = "auto";
	REFUSED(scree_batch_create(&def, &batch),
	        "scree_batch_create: def.device is \"auto\", which worlds of a batch cannot have yet");
	def.device = "gpu";
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.device is \"gpu\", must be \"auto\", \"cpu\", "
	                                          "\"opencl\" or \"opencl:NAME\", NAME a part "
	                                          "of the name of the device or of its driver, case ignored");
	def.device = "cpu";
	def.lanes = 3;
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.lanes is 3, must be 0, 1, 4, 8 or 16");
	def.lanes = 0;
	def.templates = &sleeper;
	scree_tuning tuning;
	OK(scree_world_step(sleeper, STEP, 4));
	OK(scree_world_get_tuning(sleeper, &tuning));
	tuning.sleep = false;
	OK(scree_world_set_tuning(sleeper, &tuning));
	REFUSED(scree_batch_create(&def, &batch),
	        "scree_batch_create: sleep of template 0 was turned off since its last step; it must take a step first");
	assert_null(batch);
	def.templates = &world;
	OK(scree_batch_create(&def, &batch));
	REFUSED(scree_batch_step(batch, 2.0f, 4, 1), "scree_batch_step: dt is 2, must be 0 or from 1e-09 to 1");
	REFUSED(scree_batch_step(batch, STEP, 0, 1), "scree_batch_step: substeps is 0, must be from 1 to 64");
	REFUSED(scree_batch_step(batch, STEP, 4, -1), "scree_batch_step: steps is -1, must be at least 0");
	REFUSED(scree_batch_get_hashes(batch, NULL), "scree_batch_get_hashes: hashes is null");
	REFUSED(scree_batch_step(NULL, STEP, 4, 1), "scree_batch_step: batch is null");
	assert_int_equal(scree_batch_get_worlds(NULL), 0);
	OK(scree_batch_step(batch, STEP, 4, 2));
	scree_batch_destroy(batch);
	scree_batch_destroy(NULL);
	scree_world_destroy(world);
	scree_world_destroy(sleeper);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(scenes_are_equal),
	    cmocka_unit_test(templates_are_mixed),
	    cmocka_unit_test(bays_grow),
	    cmocka_unit_test(places_do_not_matter),
	    cmocka_unit_test(lengths_may_change),
	    cmocka_unit_test(bad_arguments_are_refused),
	    cmocka_unit_test(stages_are_measured),
	    cmocka_unit_test(visits_are_refused),
	    cmocka_unit_test(approvals_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
