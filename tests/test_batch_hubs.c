// SPDX-License-Identifier: MIT
// test_batch_hubs.c -- checks that masses and joints which change the hub of a spoke do so in the next step, whether the
// contacts of the world have a new layout or not: alone, in a batch, and after a snapshot.
//
// Formula: hash(world of a batch, n steps) = hash(the same world alone, n steps), if another world of the batch makes the
// layout new in each step.
#include "support/batch_worlds.h"
#include "support/make_bodies.h"
#include "support/make_joints.h"

#define TEETH 40
#define PITCH 0.5f

// Adds a body of many boxes in a row. y: height of their centers, m.
static scree_body add_comb(scree_world* world, float y)
{
	scree_attribute tooth = box_attribute(world, 0.2f, 0.2f);
	scree_body comb = add_body(world, SCREE_BODY_DYNAMIC, tooth, 0.0f, y, 0.0f);
	for (int k = 1; k < TEETH; ++k)
	{
		scree_collidable_def more = scree_collidable_def_default();
		more.attribute = tooth;
		more.body = comb;
		more.pose.position.x = PITCH * (float)k;
		OK(scree_collidable_create(world, &more, NULL));
	}
	return comb;
}

static void step_some(scree_world* world, int steps)
{
	for (int step = 0; step < steps; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
}

// Two combs rest on each other and on the ground. Then the upper one becomes lighter, and with it the hub of their contacts.
static scree_world* lighter_comb(void)
{
	scree_world* world = open_awake(-10.0f);
	add_floor(world);
	scree_body lower = add_comb(world, 0.2f), upper = add_comb(world, 0.6f);
	step_some(world, 20);
	scree_mass mass;
	OK(scree_body_get_mass(world, upper, &mass));
	mass.mass *= 0.25f;
	mass.inertia *= 0.25f;
	OK(scree_body_set_mass(world, upper, mass));
	(void)lower;
	return world;
}

// A comb lies on another one, which two joints hold; it has a joint less, so the lower one is the hub. Then gravity acts, a
// joint breaks, and the upper comb is the hub. No contact begins or ends.
static scree_world* breaking_comb(void)
{
	scree_world* world = open_awake(0.0f);
	scree_body upper = add_comb(world, 10.4f), lower = add_comb(world, 10.0f);
	float middle = 0.5f * PITCH * (float)(TEETH - 1);
	scree_joint_def joint = joint_def_at(world, SCREE_JOINT_WELD, NOBODY, lower, middle, 10.0f, 0.0f);
	add_joint(world, &joint);
	joint.can_break = true;
	joint.force_threshold = 10.0f;
	add_joint(world, &joint);
	join(world, SCREE_JOINT_TARGET, NOBODY, upper, middle, 10.4f);
	step_some(world, 20);
	OK(scree_world_set_gravity(world, (scree_vec){0.5f, -10.0f}));
	return world;
}

// A crate that meets the ground in the first step.
static scree_world* falling_crate(void)
{
	scree_world* world = open_awake(-10.0f);
	add_floor(world);
	throw_body(world, add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.55f), 0.0f, -5.0f, 0.0f);
	return world;
}

// Compares a world with its copies in a batch, with its clone, and with a snapshot of it. Other worlds of the batch make new
// contacts and are reset, so that each step has a new layout. spokes: expected number of spokes.
static void check_world(scree_world* world, int spokes, int steps)
{
	const char* const devices[] = {"cpu", second_device};
	scree_world_def alone = scree_world_def_default();
	alone.device = "cpu";
	const void* bytes;
	size_t size;
	scree_world *saved, *moved, *templates[] = {world, falling_crate()};
	OK(scree_world_snapshot(world, &bytes, &size));
	OK(scree_world_clone(world, &alone, &moved));
	alone.sleep = false;
	saved = create_world(&alone);
	OK(scree_world_restore(saved, bytes, size));
	scree_batch* batches[2] = {NULL, NULL};
	scree_batch_def def = scree_batch_def_default();
	def.worlds = 4;
	def.templates = templates;
	def.template_count = 2;
	def.template_of = (const int32_t[]){1, 0, 0, 0};
	def.threads = 1;
	for (int k = 0; k < 2 && devices[k][0]; ++k)
	{
		def.device = devices[k];
		OK(scree_batch_create(&def, batches + k));
	}
	for (int step = 1; step <= steps; ++step)
	{
		OK(scree_world_step(world, STEP, SUBSTEPS));
		OK(scree_world_step(saved, STEP, SUBSTEPS));
		OK(scree_world_step(moved, STEP, SUBSTEPS));
		assert_true(hash_of(saved) == hash_of(world) && hash_of(moved) == hash_of(world));
		for (int k = 0; k < 2 && batches[k]; ++k)
		{
			uint64_t hashes[4];
			if (step % 2 == 0)
				OK(scree_batch_reset(batches[k], (const uint8_t[]){1, 0, 0, 0}));
			OK(scree_batch_step(batches[k], STEP, SUBSTEPS, 1));
			OK(scree_batch_get_hashes(batches[k], hashes));
			if (hashes[1] != hash_of(world) || hashes[2] != hashes[1])
				fail_msg("%s: worlds of the batch differ after step %d", devices[k], step);
		}
	}
	scree_counters counters;
	OK(scree_world_get_counters(world, &counters));
	assert_int_equal(counters.spokes, spokes);
	for (int k = 0; k < 2; ++k)
		scree_batch_destroy(batches[k]);
	scree_world_destroy(world);
	scree_world_destroy(saved);
	scree_world_destroy(moved);
	scree_world_destroy(templates[1]);
}

static void masses_choose_hubs(void** state)
{
	(void)state;
	check_world(lighter_comb(), 2 * TEETH, 10);
	assert_int_equal(scree_memory(), 0);
}

static void joints_choose_hubs(void** state)
{
	(void)state;
	check_world(breaking_comb(), TEETH, 10);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(masses_choose_hubs),
	    cmocka_unit_test(joints_choose_hubs),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
