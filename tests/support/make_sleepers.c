// SPDX-License-Identifier: MIT
// make_sleepers.c -- makes worlds in which bodies sleep, and checks that a test has the same bits on each device.
#include "support/make_sleepers.h"

#define MOST_WORLDS 256

static int threads, lanes;
static uint64_t hashes[MOST_WORLDS]; // hashes of the first group, in the order of close_sleepers
static int known, next;

static int use(const char* device, int count, int width)
{
	test_device = device;
	threads = count;
	lanes = width;
	next = 0;
	return 0;
}

int use_one_thread(void** state)
{
	(void)state;
	known = 0;
	return use("cpu", 1, 1);
}

int use_three_threads(void** state)
{
	(void)state;
	return use("cpu", 3, 0);
}

int use_sleepers_on_opencl(void** state)
{
	(void)state;
	return use("opencl", 0, 0);
}

scree_world* open_sleepers(float gravity_y)
{
	scree_world_def def = scree_world_def_default();
	def.device = test_device;
	def.threads = threads;
	def.lanes = lanes;
	def.gravity.y = gravity_y;
	def.sleep = true;
	scree_world* world = create_world(&def);
	if (gravity_y != 0.0f)
		add_floor(world);
	return world;
}

void close_sleepers(scree_world* world)
{
	run_steps(world, 3);
	uint64_t hash = hash_of(world);
	scree_world_destroy(world);
	assert_true(next < MOST_WORLDS);
	if (threads == 1)
		hashes[known++] = hash;
	else if (next >= known || hashes[next] != hash)
		fail_msg("world %d of this group has the hash %016llx, and %016llx with 1 thread and 1 lane", next,
		         (unsigned long long)hash, (unsigned long long)(next < known ? hashes[next] : 0));
	++next;
}

scree_body add_stack(scree_world* world, float x, scree_body bodies[STACK])
{
	for (int k = 0; k < STACK; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, x, 0.5f + (float)k);
	return bodies[0];
}

bool is_awake(scree_world* world, scree_body body)
{
	bool awake;
	OK(scree_body_get_awake(world, body, &awake));
	return awake;
}

void expect_awake(scree_world* world, const scree_body* bodies, int count, bool awake)
{
	bool found[64];
	OK(scree_bodies_get_awake(world, bodies, found, count));
	for (int k = 0; k < count; ++k)
		if (found[k] != awake)
			fail_msg("body %d is %s", k, awake ? "asleep" : "awake");
}

void run_to_sleep(scree_world* world, const scree_body* bodies, int count)
{
	bool found[64] = {true}, any = true;
	for (int step = 0; step < 200 && any; ++step)
	{
		run_steps(world, 1);
		OK(scree_bodies_get_awake(world, bodies, found, count));
		any = false;
		for (int k = 0; k < count; ++k)
			any |= found[k];
	}
	expect_awake(world, bodies, count, false);
}

void run_as_before(scree_world* world, const scree_body* bodies, int count, int steps, bool awake)
{
	for (int k = 0; k < steps; ++k)
	{
		run_steps(world, 1);
		expect_awake(world, bodies, count, awake);
	}
}
