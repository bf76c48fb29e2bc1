// SPDX-License-Identifier: MIT
// test_blasts.c -- checks that explosions push the right bodies with the right impulses at the right points, equally on
// all devices.
#include "support/make_bodies.h"
#include "support/scenarios.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int blast(scree_world* world, float x, float y, float radius, float falloff, float impulse)
{
	scree_blast_def def = scree_blast_def_default();
	def.position = (scree_vec){x, y};
	def.radius = radius;
	def.falloff = falloff;
	def.impulse = impulse;
	int count;
	OK(scree_world_blast(world, &def, &count));
	return count;
}

// A crate of 2 m by 1 m and 2 kg gets the impulse of the blast times the width of the crate as seen from the blast. The
// impulse acts at the point of the crate that is nearest to the blast.
static void impulses_follow_the_width(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body wide = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.5f, 0.0f, 3.0f);
	assert_int_equal(blast(world, 0.0f, 0.0f, 5.0f, 0.0f, 4.0f), 1);
	scree_velocity v = velocity_of(world, wide);
	NEAR(v.linear.x, 0.0, 1e-6);
	NEAR(v.linear.y, 4.0 * 2.0 / 2.0, 1e-5);
	NEAR(v.angular, 0.0, 1e-6);

	// a blast from the side, 0.3 m off center, also rotates the crate
	throw_body(world, wide, 0.0f, 0.0f, 0.0f);
	assert_int_equal(blast(world, 3.0f, 3.3f, 5.0f, 0.0f, 4.0f), 1);
	v = velocity_of(world, wide);
	NEAR(v.linear.x, -4.0 * 1.0 / 2.0, 1e-5);
	NEAR(v.angular, 0.3 * 4.0 * 1.0 / (2.0 * (4.0 + 1.0) / 12.0), 1e-4);

	// at half of the falloff distance the impulse is half of the full impulse, and beyond the falloff distance it is 0;
	// a negative impulse pulls
	throw_body(world, wide, 0.0f, 0.0f, 0.0f);
	assert_int_equal(blast(world, 0.0f, 0.0f, 1.5f, 2.0f, -4.0f), 1);
	NEAR(velocity_of(world, wide).linear.y, -2.0, 1e-5);
	throw_body(world, wide, 0.0f, 0.0f, 0.0f);
	assert_int_equal(blast(world, 0.0f, 0.0f, 1.0f, 1.0f, 4.0f), 0);
	NEAR(velocity_of(world, wide).linear.y, 0.0, 1e-6);

	// a blast inside the crate pushes in the direction from the blast to the centroid; a blast at the centroid pushes
	// in any direction, with a finite velocity
	assert_int_equal(blast(world, 0.0f, 2.9f, 1.0f, 1.0f, 4.0f), 1);
	NEAR(velocity_of(world, wide).linear.y, 4.0, 1e-5);
	assert_int_equal(blast(world, 0.0f, 3.0f, 1.0f, 1.0f, 4.0f), 1);
	check_finite(world);
	scree_world_destroy(world);
}

static void who_is_pushed(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_crate(world, SCREE_BODY_STATIC, 2.0f, 0.0f);
	add_crate(world, SCREE_BODY_KINEMATIC, -2.0f, 0.0f);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 2.0f);
	scree_body off = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, -2.0f);
	OK(scree_body_set_enabled(world, off, false));
	assert_int_equal(blast(world, 0.0f, 0.0f, 3.0f, 1.0f, 1.0f), 1);
	scree_blast_def def = scree_blast_def_default();
	def.radius = 3.0f;
	def.mask = 2;
	int count;
	OK(scree_world_blast(world, &def, &count));
	assert_int_equal(count, 0);
	OK(scree_world_blast(world, &def, NULL));
	NEAR(velocity_of(world, crate).linear.y, 1.0, 1e-5);
	assert_true(velocity_of(world, off).linear.y == 0.0f);
	scree_world_destroy(world);
}

// Applies several blasts to a heap, 70 km from the origin. Returns the hash of the world.
static uint64_t blown_heap(const Variant* variant)
{
	scree_world* world = open_default_variant(variant);
	const float x = 70000.0f;
	add_box(world, SCREE_BODY_STATIC, 50.0f, 1.0f, x, -1.0f);
	for (int i = 0; i < 100; ++i)
		add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f + 0.002f * (float)i, x + (float)(i % 10) - 5.0f,
		        0.5f + (float)(i / 10));
	int pushed = 0;
	for (int step = 0; step < 40; ++step)
	{
		if (step % 10 == 9)
			pushed += blast(world, x + 0.3f * (float)step - 5.0f, 0.2f, 2.0f, 3.0f, step % 20 == 9 ? 2.0f : -1.0f);
		if (variant->other[0] && step % 10 == 8)
			OK(scree_world_move(world, step % 20 == 8 ? variant->other : variant->device));
		run_steps(world, 1);
	}
	assert_true(pushed > 40);
	uint64_t hash = hash_of(world);
	scree_world_destroy(world);
	return hash;
}

static void all_devices_agree(void** state)
{
	(void)state;
	check_equal(blown_heap);
}

// The points of several blasts are read from one list of query results. The list stays valid, although each blast runs
// a query.
static void lists_stay(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	for (int k = 0; k < 900; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.2f, 0.2f, (float)(k % 30), (float)(k / 30));
	scree_query_results list;
	OK(scree_world_overlap_box(world, (scree_box){{-0.5f, -0.5f}, {2.5f, 2.5f}}, &list));
	assert_int_equal(list.count, 9);
	const scree_query_result* found = list.results;
	scree_query_result kept[9];
	memcpy(kept, found, sizeof kept);
	for (int k = 0; k < list.count; ++k)
		assert_int_equal(blast(world, found[k].point.x, found[k].point.y, 60.0f, 1.0f, 1.0f), 900);
	assert_memory_equal(kept, found, sizeof kept);
	assert_int_equal(list.first[1], 9);
	scree_world_destroy(world);
}

// Bodies that have left the world are not pushed; their neighbors inside the world are pushed.
static void beyond_the_world(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body lost = add_crate(world, SCREE_BODY_DYNAMIC, 99998.0f, 0.0f),
	           near = add_crate(world, SCREE_BODY_DYNAMIC, 99990.0f, 0.0f);
	OK(scree_body_set_linear_velocity(world, lost, (scree_vec){300.0f, 0.0f}));
	run_steps(world, 2);
	assert_true(position_of(world, lost).x > SCREE_MAX_COORDINATE);
	assert_int_equal(blast(world, 99999.0f, 0.0f, 50.0f, 1.0f, 1.0f), 1);
	NEAR(velocity_of(world, lost).linear.x, 300.0, 1e-3);
	assert_true(velocity_of(world, near).linear.x < -0.5f);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(impulses_follow_the_width), cmocka_unit_test(who_is_pushed),
	    cmocka_unit_test(all_devices_agree),         cmocka_unit_test(lists_stay),
	    cmocka_unit_test(beyond_the_world),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
