// SPDX-License-Identifier: MIT
// test_batch_share.c -- checks rows of a batch in memory that is shared with a device: they must equal rows in memory of the host.
//
// No driver for CPUs shares memory, so this test wraps functions of PoCL (support/sharing_driver.h).
#include "batch/batch.h"
#include "support/batch_checks.h"
#include "support/make_bodies.h"
#include "support/sharing_driver.h"
#include <math.h>

#define WORLDS  37
#define INPUTS  3
#define OUTPUTS 10

typedef struct
{
	scree_batch* batch;
	float *inputs, *outputs; // rows, in memory of the host or in shared memory
} Side;

static scree_world* open_template(scree_body bodies[3], float contact_hertz)
{
	scree_tuning tuning;
	scree_world* world = open_world_on("cpu", 1, (float)-G);
	add_floor(world);
	for (int k = 0; k < 3; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.4f * (float)k, 0.6f + 1.05f * (float)k);
	OK(scree_world_get_tuning(world, &tuning));
	tuning.contact_hertz = contact_hertz;
	OK(scree_world_set_tuning(world, &tuning));
	return world;
}

static scree_status open_batch(const char* device, scree_world** templates, int count, scree_batch** batch)
{
	scree_batch_def def = scree_batch_def_default();
	def.worlds = WORLDS;
	def.device = device;
	def.templates = templates;
	def.template_count = count;
	return scree_batch_create(&def, batch);
}

static void bind(Side* side, const scree_body bodies[3])
{
	scree_channel in[] = {scree_channel_make(SCREE_INPUT_FORCE), scree_channel_make(SCREE_INPUT_TORQUE)};
	scree_channel out[] = {scree_channel_make(SCREE_OUTPUT_POSE), scree_channel_make(SCREE_OUTPUT_VELOCITY),
	                       scree_channel_make(SCREE_OUTPUT_TOUCH)};
	in[0].body = out[0].body = bodies[0];
	in[1].body = out[2].body = bodies[1];
	out[1].body = bodies[2];
	OK(scree_batch_bind(side->batch, SCREE_STEP_INPUTS, in, 2, NULL));
	OK(scree_batch_bind(side->batch, SCREE_OUTPUTS, out, 3, NULL));
	side->inputs = scree_batch_get_rows(side->batch, SCREE_STEP_INPUTS);
	side->outputs = scree_batch_get_rows(side->batch, SCREE_OUTPUTS);
}

static void check_hashes(const Side sides[2])
{
	uint64_t hashes[2][WORLDS];
	for (int k = 0; k < 2; ++k)
		OK(scree_batch_get_hashes(sides[k].batch, hashes[k]));
	assert_memory_equal(hashes[0], hashes[1], sizeof hashes[0]);
}

static void set_inputs(const Side sides[2])
{
	for (int k = 0; k < WORLDS * INPUTS; ++k)
		sides[0].inputs[k] = sides[1].inputs[k] = 0.1f * (float)(random_below(2000) - 1000);
}

// Checks that both sides refuse a value with the same sentence, and change nothing.
static void refuse_value(const Side sides[2], int at, float value)
{
	char sentence[512];
	float kept = sides[0].inputs[at];
	sides[0].inputs[at] = sides[1].inputs[at] = value;
	sides[1].inputs[WORLDS * INPUTS - 1] = NAN; // the first one is named
	assert_int_equal(scree_batch_step(sides[0].batch, 0.02f, 4, 1), SCREE_ERROR_INVALID);
	snprintf(sentence, sizeof sentence, "%s", scree_error());
	REFUSED(scree_batch_step(sides[1].batch, 0.02f, 4, 1), sentence);
	sides[0].inputs[at] = sides[1].inputs[at] = kept;
	sides[1].inputs[WORLDS * INPUTS - 1] = sides[0].inputs[WORLDS * INPUTS - 1];
	check_hashes(sides);
}

static void step_both(const Side sides[2], int steps)
{
	for (int step = 0; step < steps; ++step)
	{
		uint8_t mask[WORLDS];
		for (int k = 0; k < WORLDS; ++k)
			mask[k] = random_below(6) == 0;
		set_inputs(sides);
		for (int k = 0; k < 2; ++k)
		{
			if (step % 5 == 3)
				OK(scree_batch_pause(sides[k].batch, step % 10 == 3 ? mask : NULL));
			if (step % 4 == 1)
				OK(scree_batch_reset(sides[k].batch, mask));
			OK(scree_batch_step(sides[k].batch, 0.02f, 4, 1 + step % 2));
			if (step % 4 == 2)
				OK(scree_batch_observe(sides[k].batch));
		}
		assert_memory_equal(sides[0].outputs, sides[1].outputs, WORLDS * OUTPUTS * sizeof(float));
		check_hashes(sides);
	}
}

// Compares batches whose worlds are in one block or in several ones.
static void compare_sides(int parts)
{
	scree_body bodies[3];
	scree_world* world = open_template(bodies, 30.0f);
	Side sides[2];
	OK(open_batch("cpu", &world, 1, &sides[0].batch));
	batch_parts_setting = parts;
	OK(open_batch(POCL, &world, 1, &sides[1].batch));
	batch_parts_setting = 0;
	assert_int_equal(sides[1].batch->block_count, parts);
	for (int k = 0; k < 2; ++k)
		bind(sides + k, bodies);

	void *inputs, *outputs;
	size_t least = WORLDS * INPUTS * sizeof(float), bytes = 4096;
	int input_file = make_file(bytes, &inputs), output_file = make_file(bytes, &outputs);
	expect_refusal(scree_batch_share_rows(sides[1].batch, SCREE_STEP_INPUTS, input_file, least - 1),
	               SCREE_ERROR_INVALID, "bytes is 443, must be at least 444 for 37 worlds and 3 columns");
	creation_fails = true;
	expect_refusal(scree_batch_share_rows(sides[1].batch, SCREE_STEP_INPUTS, input_file, bytes),
	               SCREE_ERROR_NOT_SUPPORTED, "CL_INVALID_VALUE");
	creation_fails = false;
	assert_ptr_equal(scree_batch_get_rows(sides[1].batch, SCREE_STEP_INPUTS), sides[1].inputs);
	OK(scree_batch_share_rows(sides[1].batch, SCREE_STEP_INPUTS, input_file, least));
	OK(scree_batch_share_rows(sides[1].batch, SCREE_OUTPUTS, output_file, bytes));
	assert_null(scree_batch_get_rows(sides[1].batch, SCREE_STEP_INPUTS));
	assert_null(scree_batch_get_rows(sides[1].batch, SCREE_OUTPUTS));
	sides[1].inputs = inputs;
	sides[1].outputs = outputs;
	step_both(sides, 24);
	refuse_value(sides, 7 * INPUTS + 1, NAN);
	refuse_value(sides, 0, INFINITY);
	refuse_value(sides, (WORLDS - 1) * INPUTS, -INFINITY);
	step_both(sides, 6);

	// sharing ends when a list is bound again
	for (int k = 0; k < 2; ++k)
		bind(sides + k, bodies);
	assert_non_null(sides[1].inputs);
	step_both(sides, 4);
	for (int k = 0; k < 2; ++k)
		scree_batch_destroy(sides[k].batch);
	scree_world_destroy(world);
	munmap(inputs, bytes);
	munmap(outputs, bytes);
	close(input_file);
	close(output_file);
}

static void test_shared_rows(void** state)
{
	(void)state;
	if (!has_pocl())
		skip();
	compare_sides(1);
	compare_sides(3);
}

// Lists that cannot be shared.
static void test_refusals(void** state)
{
	(void)state;
	if (!has_pocl())
		skip();
	scree_body bodies[3];
	scree_world* worlds[2] = {open_template(bodies, 30.0f), open_template(bodies, 50.0f)};
	scree_batch* batch;
	OK(open_batch(POCL, worlds, 1, &batch));
	expect_refusal(scree_batch_share_rows(NULL, SCREE_OUTPUTS, 0, 4096), SCREE_ERROR_INVALID, "batch is null");
	expect_refusal(scree_batch_share_rows(batch, (scree_channels)3, 0, 4096), SCREE_ERROR_INVALID, "is 3, not a list");
	expect_refusal(scree_batch_share_rows(batch, SCREE_OUTPUTS, -1, 4096), SCREE_ERROR_INVALID,
	               "file_descriptor is -1");
	expect_refusal(scree_batch_share_rows(batch, SCREE_OUTPUTS, 0, 4096), SCREE_ERROR_INVALID, "has no channels");
	expect_refusal(scree_batch_share_rows(batch, SCREE_RESET_INPUTS, 0, 4096), SCREE_ERROR_NOT_SUPPORTED, "of resets");
	const scree_channel_kind kinds[] = {SCREE_INPUT_POSE, SCREE_INPUT_MASS};
	for (int k = 0; k < 2; ++k)
	{
		scree_channel channel = scree_channel_make(kinds[k]);
		channel.body = bodies[0];
		OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &channel, 1, NULL));
		expect_refusal(scree_batch_share_rows(batch, SCREE_STEP_INPUTS, 0, 4096), SCREE_ERROR_NOT_SUPPORTED,
		               "poses, targets or parameters");
	}
	scree_batch_destroy(batch);

	Side side;
	OK(open_batch(POCL, worlds, 2, &side.batch));
	bind(&side, bodies);
	expect_refusal(scree_batch_share_rows(side.batch, SCREE_OUTPUTS, 0, 4096), SCREE_ERROR_NOT_SUPPORTED,
	               "different tunings");
	scree_batch_destroy(side.batch);
	OK(open_batch("cpu", worlds, 1, &side.batch));
	bind(&side, bodies);
	expect_refusal(scree_batch_share_rows(side.batch, SCREE_OUTPUTS, 0, 4096), SCREE_ERROR_NOT_SUPPORTED,
	               "the rows of a batch on cpu are copied");
	scree_batch_destroy(side.batch);
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(worlds[k]);
}

int main(void)
{
	static char extension[] = "cl_khr_external_memory_opaque_fd";
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_prestate_setup_teardown(test_shared_rows, teach, forget, extension),
	    cmocka_unit_test_prestate_setup_teardown(test_refusals, teach, forget, extension),
	};
	return scree_opencl_hint()[0] == '\0' ? cmocka_run_group_tests(tests, NULL, NULL) : 77;
}
