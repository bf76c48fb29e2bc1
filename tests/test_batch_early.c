// SPDX-License-Identifier: MIT
// test_batch_early.c -- checks batches whose solve begins before the host has read a new layout of the constraints: the form of GPUs,
// on an OpenCL CPU too.
//
// Formula: hash(world, OpenCL, n steps) = hash(world, CPU, n steps), after each step.
#include "backend/solve_form.h"
#include "batch/batch.h"
#include "support/make_bodies.h"
#include "support/make_joints.h"
#include "support/second_device.h"
#include "tools/common/random_numbers.h"
#include <string.h>

#define WORLDS 24

typedef struct // the same worlds on the CPU and on OpenCL
{
	scree_batch* batch[2];
	int early; // number of steps whose solve had a layout that the host had not read
} Twins;

static void open_twins(Twins* twins, scree_world* world, const scree_channel* input)
{
	for (int k = 0; k < 2; ++k)
	{
		scree_batch_def def = scree_batch_def_default();
		def.worlds = WORLDS;
		def.device = k == 0 ? "cpu" : second_device;
		def.templates = &world;
		def.template_count = 1;
		solve_form_setting = FORM_TILES; // batches then have the form of GPUs
		OK(scree_batch_create(&def, twins->batch + k));
		solve_form_setting = FORM_ANY;
		OK(scree_batch_bind(twins->batch[k], SCREE_STEP_INPUTS, input, 1, NULL));
	}
	twins->early = 0;
}

// Takes a step with random forces, up to `most` newtons, and compares all hashes. mask: worlds that are reset; may be null.
static void step_twins(Twins* twins, uint64_t* seed, float most, const uint8_t* mask)
{
	uint64_t hashes[2][WORLDS];
	float* rows = scree_batch_get_rows(twins->batch[0], SCREE_STEP_INPUTS);
	for (int k = 0; k < 2 * WORLDS; ++k)
		rows[k] = random_between(seed, -most, most);
	memcpy(scree_batch_get_rows(twins->batch[1], SCREE_STEP_INPUTS), rows, sizeof *rows * 2 * WORLDS);
	for (int k = 0; k < 2; ++k)
	{
		if (mask)
			OK(scree_batch_reset(twins->batch[k], mask));
		OK(scree_batch_step(twins->batch[k], 1.0f / 60.0f, 4, 1));
		OK(scree_batch_get_hashes(twins->batch[k], hashes[k]));
	}
	assert_memory_equal(hashes[0], hashes[1], sizeof hashes[0]);
	const Counters* c = &twins->batch[1]->blocks[0].pipeline.counters;
	twins->early += c->kept && c->changed;
}

static void close_twins(Twins* twins, scree_world* world)
{
	for (int k = 0; k < 2; ++k)
		scree_batch_destroy(twins->batch[k]);
	scree_world_destroy(world);
}

// Returns a world with crates and a pendulum above a floor, and the channel of a force on one crate. Its solve has presses if the
// pendulum hangs from the ground, which joints hold.
static scree_world* open_crates(bool hangs, scree_channel* force)
{
	scree_world* world = open_world_on("cpu", 1, (float)-G);
	add_floor(world);
	force->body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.6f);
	scree_body second = add_crate(world, SCREE_BODY_DYNAMIC, 0.3f, 1.8f),
	           third = add_crate(world, SCREE_BODY_DYNAMIC, 2.0f, 1.2f);
	join(world, SCREE_JOINT_REVOLUTE, second, third, 1.2f, 1.5f);
	if (hangs)
		join(world, SCREE_JOINT_REVOLUTE, NOBODY, add_crate(world, SCREE_BODY_DYNAMIC, -2.0f, 2.0f), -2.0f, 3.0f);
	return world;
}

static void moving_worlds(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	for (int hangs = 0; hangs < 2; ++hangs)
	{
		Twins twins;
		scree_channel force = scree_channel_make(SCREE_INPUT_FORCE);
		scree_world* world = open_crates(hangs, &force);
		open_twins(&twins, world, &force);
		uint64_t seed = 3;
		for (int step = 0; step < 60; ++step)
		{
			uint8_t mask[WORLDS];
			for (int k = 0; k < WORLDS; ++k)
				mask[k] = random_below(&seed, 10) == 0;
			step_twins(&twins, &seed, 60.0f, step % 3 == 0 ? NULL : mask);
		}
		print_message("%d of 60 steps began a solve with a layout that the host had not read\n", twins.early);
		assert_true(twins.early > 20);
		close_twins(&twins, world);
	}
}

// Lets the bodies of a world fall on its floor, pushed by small forces. Returns the number of hubs at the end.
static int fall(scree_world* world, scree_body pushed, uint64_t seed, int steps)
{
	Twins twins;
	scree_channel force = scree_channel_make(SCREE_INPUT_FORCE);
	force.body = pushed;
	open_twins(&twins, world, &force);
	for (int step = 0; step < steps; ++step)
		step_twins(&twins, &seed, 1.0f, NULL);
	int hubs = twins.batch[1]->blocks[0].pipeline.counters.hubs;
	close_twins(&twins, world);
	return hubs;
}

// A heap meets the floor in all worlds at the same step, so the constraints get more places than the solve has room for.
static void many_contacts_at_once(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world* world = open_world_on("cpu", 1, (float)-G);
	scree_body last = {0, 0};
	add_floor(world);
	for (int k = 0; k < 40; ++k)
		last = add_crate(world, SCREE_BODY_DYNAMIC, 1.2f * (float)k, 1.5f);
	fall(world, last, 4, 40);
}

// A body with more contacts than colors becomes a hub, whose contacts this form does not solve.
static void hubs_enter(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world* world = open_world_on("cpu", 1, (float)-G);
	add_floor(world);
	scree_body plank = add_box(world, SCREE_BODY_DYNAMIC, 20.0f, 0.5f, 0.0f, 0.5f);
	for (int k = 0; k < 36; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 1.1f * (float)k - 19.0f, 2.0f + 0.05f * (float)k);
	assert_true(fall(world, plank, 5, 60) > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(moving_worlds), cmocka_unit_test(many_contacts_at_once),
	                                   cmocka_unit_test(hubs_enter)};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
