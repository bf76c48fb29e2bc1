// SPDX-License-Identifier: MIT
// test_batch_damage.c -- checks that states of worlds with wrong values and a right checksum do no harm.
//
// Formula: a state with a wild index or number is refused with a sentence, and nothing changes; or it is loaded, and then the
// batch takes steps. A build with sanitizers finds accesses beyond a pool.
#include "batch/world_row.h"
#include "constraints/constraint_kinds.h"
#include "support/batch_checks.h"
#include "support/make_bodies.h"
#include "support/make_joints.h"
#include "support/make_paths.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct
{
	scree_batch* batch;
	char *good, *bad; // a state, and a damaged copy
	size_t bytes;
	int refused, loaded;
} Damage;

// A world with contacts, a hub, joints with motors, a joint on a path, and a one-way platform.
static scree_world* rich_world(void)
{
	scree_world* world = stay_awake(open_world(-10.0f));
	scree_shape plank;
	scree_body bodies[4];
	add_floor(world);
	OK(scree_shape_make_box(20.0f, 0.2f, &plank));
	add_shape(world, SCREE_BODY_DYNAMIC, plank, 0.0f, 0.2f, 0.0f);
	for (int k = 0; k < 34; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 1.1f * ((float)k - 16.5f), 0.9f);
	for (int k = 0; k < 4; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 1.1f * (float)k, 6.0f);
	scree_joint_def motor = joint_def_at(world, SCREE_JOINT_REVOLUTE, bodies[0], bodies[1], 0.55f, 6.0f, 0.0f);
	motor.coordinates[SCREE_ANGLE].motor = true;
	motor.coordinates[SCREE_ANGLE].motor_speed = 2.0f;
	motor.coordinates[SCREE_ANGLE].motor_max = 20.0f;
	add_joint(world, &motor);
	const scree_vec points[] = {{2.0f, 6.0f}, {5.0f, 8.0f}, {9.0f, 6.0f}};
	ride(world, add_path(world, points, 3, false), bodies[2], true);
	for (int step = 0; step < 30; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	return world;
}

// Gives the damaged state a right checksum.
static void seal(Damage* d)
{
	RowHead head;
	memcpy(&head, d->bad, sizeof head);
	row_seal(d->bad, &head);
}

// Loads the damaged state: it is refused and the world keeps its hash, or the batch can take steps with it.
static void load_bad(Damage* d, const char* name, int item)
{
	const int32_t first = 0;
	uint64_t before[2], after[2];
	OK(scree_batch_get_hashes(d->batch, before));
	scree_status status = scree_batch_load(d->batch, &first, 1, d->bad, 0);
	if (status != SCREE_OK)
	{
		assert_int_equal(status, SCREE_ERROR_INVALID);
		if (strstr(scree_error(), "scree_batch_load: state 0 is refused: ") != scree_error())
			fail_msg("%s %d: %s", name, item, scree_error());
		OK(scree_batch_get_hashes(d->batch, after));
		assert_memory_equal(before, after, sizeof before);
		++d->refused;
		return;
	}
	OK(scree_batch_step(d->batch, STEP, SUBSTEPS, 2));
	OK(scree_batch_get_hashes(d->batch, after));
	++d->loaded;
	OK(scree_batch_reset(d->batch, NULL));
}

// Replaces single words of items of each pool by wild values.
static void damage_words(Damage* d, const RowHead* head)
{
	static const uint32_t wild[] = {0x7fffffff, 0xffffffff, 0x80000000, 0x7fc00000, 0x7f800000,
	                                0xff7fffff, 0x00010000, 63,         64,         1000};
	size_t at[POOL_COUNT];
	row_layout(head->count, at);
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int kind = row_kind((PoolId)pool), words = (int)(pool_info[pool].bytes / 4);
		if (kind < 0 || head->count[kind] == 0)
			continue;
		for (int word = 0; word < words; ++word)
			for (int k = 0; k < (quick() ? 3 : 10); ++k)
			{
				int item = random_below(head->count[kind]);
				memcpy(d->bad, d->good, d->bytes);
				char* place = d->bad + at[pool] + ((size_t)item * (size_t)words + (size_t)word) * 4;
				memcpy(place, wild + random_below((int)(sizeof wild / sizeof *wild)), 4);
				seal(d);
				load_bad(d, pool_info[pool].name, item);
			}
	}
}

// Replaces words of the head behind the numbers of items. Targets are refused with a sentence of their own.
static void damage_head(Damage* d)
{
	static const uint32_t wild[] = {0x7fffffff, 0xffffffff, 0x80000000, 0x7fc00000, 1000};
	for (size_t at = offsetof(RowHead, dt); at < offsetof(RowHead, targets); at += 4)
		for (size_t k = 0; k < sizeof wild / sizeof *wild; ++k)
		{
			memcpy(d->bad, d->good, d->bytes);
			memcpy(d->bad + at, wild + k, 4);
			seal(d);
			load_bad(d, "head", (int)at);
		}
}

static Damage open_damage(scree_world* world, const char* device)
{
	Damage d = {.refused = 0};
	scree_batch_def def = scree_batch_def_default();
	const int32_t first = 0;
	def.worlds = 2;
	def.templates = &world;
	def.template_count = 1;
	def.threads = 1;
	def.device = device;
	OK(scree_batch_create(&def, &d.batch));
	OK(scree_batch_step(d.batch, STEP, SUBSTEPS, 3));
	d.bytes = scree_batch_get_state_bytes(d.batch);
	d.good = calloc(1, d.bytes);
	d.bad = calloc(1, d.bytes);
	OK(scree_batch_save(d.batch, &first, 1, d.good, d.bytes));
	return d;
}

static void close_damage(Damage* d)
{
	scree_batch_destroy(d->batch);
	free(d->good);
	free(d->bad);
}

static void wild_values_do_no_harm(void** state)
{
	(void)state;
	random_state = 1;
	scree_world* world = rich_world();
	Damage d = open_damage(world, "cpu");
	RowHead head;
	memcpy(&head, d.good, sizeof head);
	damage_words(&d, &head);
	damage_head(&d);
	print_message("%d states refused, %d loaded\n", d.refused, d.loaded);
	assert_true(d.refused > d.loaded);
	// the good state is still accepted, at any address
	const int32_t all[] = {0, 1};
	char* moved = malloc(d.bytes + 1);
	memcpy(moved + 1, d.good, d.bytes);
	OK(scree_batch_load(d.batch, all, 2, moved + 1, 0));
	free(moved);
	close_damage(&d);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// Damages one value, and expects a sentence with these words.
static void refuse_value(Damage* d, PoolId pool, int item, size_t offset, int value, const char* words)
{
	const int32_t first = 0;
	RowHead head;
	size_t at[POOL_COUNT];
	char sentence[128];
	memcpy(d->bad, d->good, d->bytes);
	memcpy(&head, d->bad, sizeof head);
	row_layout(head.count, at);
	memcpy(d->bad + at[pool] + pool_info[pool].bytes * (size_t)item + offset, &value, sizeof value);
	seal(d);
	snprintf(sentence, sizeof sentence, "scree_batch_load: state 0 is refused: %s", words);
	if (scree_batch_load(d->batch, &first, 1, d->bad, 0) != SCREE_ERROR_INVALID)
		fail_msg("a load is not refused: %s", sentence);
	if (strncmp(scree_error(), sentence, strlen(sentence)) != 0)
		fail_msg("%s, expected: %s", scree_error(), sentence);
}

static void wild_values_are_named(void** state)
{
	(void)state;
	scree_world* world = rich_world();
	Damage d = open_damage(world, "cpu");
	refuse_value(&d, POOL_pair, 0, 0, 1000000, "pair 0 is not consistent");
	refuse_value(&d, POOL_contact_bodies, 2, 4, -2, "contact_bodies 2 is not consistent");
	refuse_value(&d, POOL_contact_color, 1, 0, 64, "contact_color 1 is not consistent");
	refuse_value(&d, POOL_collidable_body, 3, 0, 5000, "collidable 3 is not consistent");
	refuse_value(&d, POOL_collidable_attribute, 3, 0, -1, "collidable 3 is not consistent");
	refuse_value(&d, POOL_world_shape, 4, offsetof(WorldShape, attribute), 77777, "world_shape 4 is not consistent");
	refuse_value(&d, POOL_continuous_body, 5, 0, 1 << 20, "body 5 is not consistent");
	refuse_value(&d, POOL_joint_data, 1, 0, 12345, "joint 1 is not consistent");
	refuse_value(&d, POOL_joint_bodies, 1, 0, 12345, "joint_bodies 1 is not consistent");
	refuse_value(&d, POOL_touching, 6, 0, 9, "touching 6 is not consistent");
	refuse_value(&d, POOL_pose, 7, 0, 0x7fc00000, "pose 7 is not consistent");
	refuse_value(&d, POOL_joint_rare_kept, 1, offsetof(JointRareKept, path_segment), 0x4b000000,
	             "joint_rare_kept 1 is not consistent");
	close_damage(&d);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(wild_values_are_named),
	    cmocka_unit_test(wild_values_do_no_harm),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
