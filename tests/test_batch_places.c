// SPDX-License-Identifier: MIT
// test_batch_places.c -- checks batches whose constraints get more places than their memory has at first: in steps, and by copies of
// many worlds.
//
// Formula: hash(world in a large block) = hash(same world in a small block) = hash(same world alone).
#include "batch/batch.h"
#include "support/batch_checks.h"
#include "support/make_joints.h"
#include "support/second_device.h"
#include <string.h>

#define WORLDS 2000
#define STEP   (1.0f / 60.0f)

typedef struct // the same worlds in one block, and in the small blocks of a CPU
{
	scree_batch *large, *small;
} Twins;

// Opens a world with crates of which two pairs are joined. settled: true if they lie on the floor; their joints then are made in the
// other order, so that they have other colors.
static scree_world* open_crates(bool settled)
{
	scree_world* world = open_world_on("cpu", 1, (float)-G);
	scree_body crates[6];
	float apart = settled ? 1.05f : 1.5f, low = settled ? 0.5f : 2.0f, up = settled ? 1.01f : 1.5f;
	add_floor(world);
	for (int k = 0; k < 6; ++k)
		crates[k] = add_crate(world, SCREE_BODY_DYNAMIC, apart * (float)(k % 3), k < 3 ? low : low + up);
	for (int k = 0; k < 4; ++k)
	{
		int first = settled ? 3 - k : k;
		join(world, SCREE_JOINT_REVOLUTE, crates[first], crates[first + 2], apart * (float)(first % 3), 2.0f);
	}
	for (int k = 0; k < (settled ? 60 : 1); ++k)
		OK(scree_world_step(world, STEP, 4));
	return world;
}

static scree_batch* open_batch(const char* device, scree_world** templates, int count, int parts)
{
	scree_batch_def def = batch_def_on(device, templates, count, WORLDS);
	scree_batch* batch;
	static int numbers[WORLDS];
	def.template_of = numbers;
	def.other_templates = true;
	batch_parts_setting = parts;
	OK(scree_batch_create(&def, &batch));
	batch_parts_setting = 0;
	return batch;
}

static Twins open_twins(const char* device, scree_world** templates, int count)
{
	Twins twins = {open_batch(device, templates, count, 1), open_batch("cpu", templates, count, 0)};
	assert_int_equal(twins.large->block_count, 1);
	assert_true(twins.small->block_count > 1);
	return twins;
}

static void close_twins(Twins* twins)
{
	scree_batch_destroy(twins->large);
	scree_batch_destroy(twins->small);
}

static void check_equal(const Twins* twins)
{
	static uint64_t large[WORLDS], small[WORLDS];
	OK(scree_batch_get_hashes(twins->large, large));
	OK(scree_batch_get_hashes(twins->small, small));
	assert_memory_equal(large, small, sizeof large);
}

static void step_twins(const Twins* twins, int steps)
{
	OK(scree_batch_step(twins->large, STEP, 4, steps));
	OK(scree_batch_step(twins->small, STEP, 4, steps));
	check_equal(twins);
}

// Draws a mask in which `part` of 100 worlds are marked.
static const uint8_t* draw(int part)
{
	static uint8_t mask[WORLDS];
	for (int k = 0; k < WORLDS; ++k)
		mask[k] = random_below(100) < part;
	return mask;
}

static void reset(const Twins* twins, const uint8_t* mask)
{
	OK(scree_batch_reset(twins->large, mask));
	OK(scree_batch_reset(twins->small, mask));
	check_equal(twins);
}

static void pause_worlds(const Twins* twins, const uint8_t* mask)
{
	OK(scree_batch_pause(twins->large, mask));
	OK(scree_batch_pause(twins->small, mask));
	check_equal(twins);
}

static void set_templates(const Twins* twins, int part)
{
	static int numbers[WORLDS];
	for (int k = 0; k < WORLDS; ++k)
		numbers[k] = random_below(100) < part;
	OK(scree_batch_set_templates(twins->large, numbers));
	OK(scree_batch_set_templates(twins->small, numbers));
}

// Worlds whose crates are in the air get all of their contacts in the same few steps.
static void check_steps(const char* device)
{
	scree_world* template = open_crates(false);
	scree_world* alone = clone_of(template);
	Twins twins = open_twins(device, &template, 1);
	const Backend* backend = twins.large->blocks[0].backend;
	static uint64_t hashes[WORLDS];
	uint64_t hash;
	int reserved = backend->capacity[PER_CONTACT_PLACE];
	for (int k = 0; k < 40; ++k)
	{
		step_twins(&twins, 1);
		OK(scree_world_step(alone, STEP, 4));
	}
	OK(scree_world_get_hash(alone, &hash));
	OK(scree_batch_get_hashes(twins.large, hashes));
	assert_true(hashes[0] == hash && hashes[WORLDS - 1] == hash);
	print_message("%s: %d places of contacts, then %d\n", device, reserved, backend->capacity[PER_CONTACT_PLACE]);
	assert_true(backend->capacity[PER_CONTACT_PLACE] > reserved);
	close_twins(&twins);
	scree_world_destroy(alone);
	scree_world_destroy(template);
}

// Resets and pauses of most worlds need more places than there are behind the layout, so they are done in parts.
static void check_copies(const char* device)
{
	scree_world* templates[2] = {open_crates(false), open_crates(true)};
	Twins twins = open_twins(device, templates, 2);
	const Backend* backend = twins.large->blocks[0].backend;
	step_twins(&twins, 30);
	for (int round = 0; round < 6; ++round)
	{
		if (round == 3) // copies of many worlds are rare again
			step_twins(&twins, 125);
		set_templates(&twins, round % 2 == 0 ? 100 : 40);
		reset(&twins, round < 2 ? NULL : draw(5 + 30 * round));
		if (round == 3) // a second and a third reset without a step between them
		{
			reset(&twins, draw(60));
			reset(&twins, NULL);
		}
		step_twins(&twins, 1 + round);
		pause_worlds(&twins, draw(15 * round));
		step_twins(&twins, 2);
		pause_worlds(&twins, draw(10));
		step_twins(&twins, 3);
	}
	pause_worlds(&twins, NULL);
	step_twins(&twins, 20);
	print_message("%s: %d places of contacts, %d of joints\n", device, backend->capacity[PER_CONTACT_PLACE],
	              backend->capacity[PER_JOINT_PLACE]);
	assert_true(backend->capacity[PER_JOINT_PLACE] < 2 * 4 * WORLDS + (COLORS + 1) * COLOR_PADDING);
	close_twins(&twins);
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(templates[k]);
}

static void contacts_begin_on_cpu(void** state)
{
	(void)state;
	check_steps("cpu");
}

static void contacts_begin_on_opencl(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	check_steps(second_device);
}

static void worlds_are_copied_on_cpu(void** state)
{
	(void)state;
	check_copies("cpu");
}

static void worlds_are_copied_on_opencl(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	check_copies(second_device);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(contacts_begin_on_cpu), cmocka_unit_test(contacts_begin_on_opencl),
	    cmocka_unit_test(worlds_are_copied_on_cpu), cmocka_unit_test(worlds_are_copied_on_opencl)};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
