// SPDX-License-Identifier: MIT
// test_query_trials.c -- checks queries in extreme worlds, and that all devices return equal results.
#include "support/random_queries.h"
#include "support/scenarios.h"
#include "tools/common/byte_hash.h"
#include "tools/common/random_numbers.h"
#include <stdlib.h>
#include <string.h>

typedef struct
{
	scree_world* world;
	scree_vec center;
	float size;
} Place;

// ---------------------------------------------------------------------------------------------------------------
// equal results on all devices
// ---------------------------------------------------------------------------------------------------------------

#define BODIES   300
#define APPROVAL 500

// Calls queries of all kinds and adds their results to the hash. Returns the new hash.
static uint64_t ask_all(const Place* place, uint64_t* seed, uint64_t hash)
{
	static scree_ray rays[APPROVAL];
	static scree_probe probes[APPROVAL];
	static scree_query_result found[APPROVAL];
	scree_shape shape = random_shape(seed, 1.0f);
	scree_query_def def = random_def(seed);
	scree_query_results list;
	for (int k = 0; k < APPROVAL; ++k)
	{
		rays[k] = (scree_ray){.origin = random_pose(seed, place->center, place->size).position,
		                      .translation = random_path(seed, place->size)};
		rays[k].radius = k % 3 ? 0.0f : 0.3f;
		probes[k] = (scree_probe){.pose = random_pose(seed, place->center, place->size),
		                          .translation = random_path(seed, place->size)};
	}
	OK(scree_world_cast_rays(place->world, &def, rays, APPROVAL, found));
	hash = hash_bytes(hash, found, sizeof found);
	OK(scree_world_cast_shapes(place->world, &def, &shape, probes, APPROVAL, found));
	hash = hash_bytes(hash, found, sizeof found);
	OK(scree_world_list_shapes(place->world, &def, &shape, probes, APPROVAL, &list));
	hash = hash_bytes(hash, list.results, (size_t)list.count * sizeof *list.results);
	OK(scree_world_list_rays(place->world, &def, rays, APPROVAL / 10, &list));
	hash = hash_bytes(hash, list.first, (APPROVAL / 10 + 1) * sizeof *list.first);
	for (int k = 0; k < APPROVAL; ++k)
		probes[k].translation = (scree_vec){0.0f, 0.0f};
	OK(scree_world_find_nearest(place->world, &def, random_below(seed, 2) ? &shape : NULL, probes, APPROVAL, 5.0f,
	                            found));
	return hash_bytes(hash, found, sizeof found);
}

// Simulates a falling heap, in which bodies are created, destroyed and changed. If `asks` is set, the function calls
// queries before and after each change. Returns the hash of all query results, and writes the hash of the world to
// *world_hash.
static uint64_t record_heap(const Variant* variant, bool asks, uint64_t* world_hash)
{
	Place place = {.center = {0.0f, 5.0f}, .size = 12.0f};
	place.world = open_default_variant(variant);
	uint64_t seed = 3, asked = 4, hash = HASH_BEGIN;
	scree_body bodies[BODIES];
	add_floor(place.world);
	for (int k = 0; k < BODIES; ++k)
	{
		scree_attribute_def surface = surface_of(random_shape(&seed, 0.5f));
		scree_pose pose = random_pose(&seed, place.center, place.size);
		bodies[k] = add_body(place.world, k % 10 ? SCREE_BODY_DYNAMIC : (scree_body_type)(k / 10 % 3),
		                     add_attribute(place.world, &surface), pose.position.x, pose.position.y, 0.3f * (float)k);
	}
	for (int step = 0; step < (quick() ? 6 : 20); ++step)
	{
		int k = random_below(&seed, BODIES);
		if (asks)
			hash = ask_all(&place, &asked, hash);
		switch (step % 5)
		{
		case 0:
			OK(scree_body_set_pose(place.world, bodies[k], random_pose(&seed, place.center, place.size)));
			break;
		case 1:
			OK(scree_body_set_enabled(place.world, bodies[k], step % 2));
			break;
		case 2:
			OK(scree_body_set_type(place.world, bodies[k], SCREE_BODY_STATIC));
			break;
		case 3:
			OK(scree_body_destroy(place.world, bodies[k]));
			bodies[k] = add_box(place.world, SCREE_BODY_DYNAMIC, 0.2f, 0.4f, 0.1f * (float)k, 9.0f);
			break;
		default:
			if (variant->other[0])
				OK(scree_world_move(place.world, step % 2 ? variant->other : variant->device));
		}
		if (asks)
			hash = ask_all(&place, &asked, hash);
		OK(scree_world_step(place.world, step == 7 ? 0.0f : STEP, SUBSTEPS));
	}
	*world_hash = hash_of(place.world);
	scree_world_destroy(place.world);
	return hash;
}

static uint64_t heap_answers(const Variant* variant)
{
	uint64_t world, answers = record_heap(variant, true, &world);
	return hash_bytes(answers, &world, sizeof world);
}

static void all_devices_agree(void** state)
{
	(void)state;
	const Variant reference = {.name = "reference", .device = "cpu", .threads = 1, .lanes = 1};
	uint64_t silent, world;
	record_heap(&reference, false, &silent);
	record_heap(&reference, true, &world);
	assert_true(world == silent); // the hash of the world is the same without queries
	check_equal(heap_answers);
}

// ---------------------------------------------------------------------------------------------------------------
// extreme worlds
// ---------------------------------------------------------------------------------------------------------------

// Thousands of crates lie at one point. An overlap returns all of them in the order of their indices, and the list of
// results grows as needed.
static void all_at_one_point(void** state)
{
	(void)state;
	enum
	{
		COUNT = 3000
	};
	scree_world* world = open_world(0.0f);
	for (int k = 0; k < COUNT; ++k)
		add_crate(world, SCREE_BODY_STATIC, 1.0f, 2.0f);
	scree_query_result found;
	scree_query_results list;
	OK(scree_world_cast_ray(world, (scree_vec){-3.0f, 2.0f}, (scree_vec){10.0f, 0.0f}, &found));
	assert_true(found.hit && found.collidable.index == 1);
	NEAR(found.fraction, 0.35, 1e-6);
	OK(scree_world_overlap_point(world, (scree_vec){1.2f, 2.2f}, &list));
	assert_int_equal(list.count, COUNT);
	for (int k = 0; k < COUNT; ++k)
		assert_true(list.results[k].inside && list.results[k].collidable.index == (uint32_t)k + 1);
	OK(scree_world_overlap_point(world, (scree_vec){1.6f, 2.2f}, &list));
	assert_int_equal(list.count, 0);
	OK(scree_world_overlap_box(world, (scree_box){{1.4f, 2.4f}, {8.0f, 9.0f}}, &list));
	assert_int_equal(list.count, COUNT);
	scree_world_destroy(world);
}

// A ray that begins inside a collidable reports this collidable, unless the query skips it. Rays of zero length, rays
// along edges and rays through corners have results too.
static void edges_and_insides(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_box(world, SCREE_BODY_STATIC, 1.0f, 1.0f, 0.0f, 0.0f);
	scree_body far = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 1.0f, 6.0f, 0.0f);
	scree_query_result found;
	OK(scree_world_cast_ray(world, (scree_vec){0.5f, 0.0f}, (scree_vec){10.0f, 0.0f}, &found));
	assert_true(found.hit && found.inside && found.fraction == 0.0f && found.normal.x == 0.0f);
	scree_query_def def = scree_query_def_default();
	def.skip_inside = true;
	scree_ray ray = {.origin = {0.5f, 0.0f}, .translation = {10.0f, 0.0f}};
	OK(scree_world_cast_rays(world, &def, &ray, 1, &found));
	assert_true(found.hit && !found.inside && found.collidable.index == 2);
	NEAR(found.fraction, 0.45, 1e-6);
	ray.ignored = far;
	OK(scree_world_cast_rays(world, &def, &ray, 1, &found));
	assert_true(!found.hit);
	OK(scree_world_cast_ray(world, (scree_vec){0.5f, 0.0f}, (scree_vec){0.0f, 0.0f}, &found));
	assert_true(found.hit && found.inside);
	OK(scree_world_cast_ray(world, (scree_vec){3.0f, 0.0f}, (scree_vec){0.0f, 0.0f}, &found));
	assert_true(!found.hit);
	OK(scree_world_cast_ray(world, (scree_vec){-3.0f, 1.0f}, (scree_vec){6.0f, 0.0f}, &found)); // along the top edge
	assert_true(found.hit);
	OK(scree_world_cast_ray(world, (scree_vec){-3.0f, 1.00001f}, (scree_vec){6.0f, 0.0f}, &found));
	assert_true(!found.hit);
	OK(scree_world_cast_ray(world, (scree_vec){-3.0f, -3.0f}, (scree_vec){6.0f, 6.0f}, &found)); // into a corner
	assert_true(found.hit);
	NEAR(found.fraction, 1.0 / 3.0, 1e-6);
	// The ray is nearly parallel to a segment 90 km away from the origin, and passes 0.4 um beside a corner of the
	// segment. The ray must hit the segment at this corner.
	scree_shape segment;
	scree_vec corners[2] = {{-0.595454574f, -0.0290360544f}, {-0.157268897f, 1.55506301f}};
	OK(scree_shape_make_segment(corners[0], corners[1], &segment));
	add_shape(world, SCREE_BODY_STATIC, segment, 89989.7109f, -89987.7812f, 0.0f);
	OK(scree_world_cast_ray(world, (scree_vec){89981.8984f, -90013.6641f}, (scree_vec){16.6944351f, 59.8361893f},
	                        &found));
	assert_true(found.hit);
	NEAR(found.fraction, 0.45854985, 2e-7);
	OK(scree_body_set_enabled(world, far, false));
	OK(scree_world_cast_ray(world, (scree_vec){3.0f, 0.0f}, (scree_vec){10.0f, 0.0f}, &found));
	assert_true(!found.hit);
	scree_world_destroy(world);
}

// The body that a query ignores is destroyed, and another body takes its slot. The query remains valid and ignores no
// body.
static void ignores_what_is_gone(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	for (int k = 0; k < count; ++k)
	{
		scree_world* world = open_default_variant(variants + k);
		scree_body gone = add_box(world, SCREE_BODY_STATIC, 1.0f, 1.0f, 0.0f, 0.0f);
		add_box(world, SCREE_BODY_STATIC, 1.0f, 1.0f, 6.0f, 0.0f);
		scree_query_def def = scree_query_def_default();
		scree_ray rays[2] = {{.origin = {-4.0f, 0.0f}, .translation = {20.0f, 0.0f}, .ignored = gone}};
		scree_probe probe = {.pose = {{-4.0f, 0.0f}, {1.0f, 0.0f}}, .ignored = gone};
		scree_mover mover = {.position = {0.0f, 1.612f}, .velocity = {0.0f, -1.0f}, .ignored = gone};
		scree_shape shape = box_shape(0.25f, 0.25f);
		scree_query_result found[2];
		scree_query_results list;
		rays[1] = rays[0];
		rays[1].ignored = SCREE_NULL_BODY;
		for (int round = 0; round < 3; ++round)
		{
			// index of the nearest collidable that is not ignored: 2 while body `gone` is ignored, 1 after a new body
			// took the slot of `gone`
			unsigned nearer = round < 2 ? 2 : 1;
			OK(scree_world_cast_rays(world, &def, rays, 2, found));
			assert_int_equal(found[0].collidable.index, nearer);
			assert_int_equal(found[1].collidable.index, round == 1 ? 2 : 1);
			OK(scree_world_list_rays(world, &def, rays, 2, &list));
			assert_int_equal(list.first[1], round == 2 ? 2 : 1);
			OK(scree_world_cast_shapes(world, &def, &shape, &probe, 1, found));
			assert_true(!found[0].hit);
			probe.translation.x = 20.0f;
			OK(scree_world_cast_shapes(world, &def, &shape, &probe, 1, found));
			assert_int_equal(found[0].collidable.index, nearer);
			probe.translation.x = 0.0f;
			OK(scree_world_find_nearest(world, &def, &shape, &probe, 1, 50.0f, found));
			assert_int_equal(found[0].collidable.index, nearer);
			OK(scree_movers_move(world, NULL, &mover, 1, STEP));
			assert_true(scree_collidable_is_null(mover.ground) == (round < 2));
			if (round == 0)
				OK(scree_body_destroy(world, gone));
			if (round == 1)
				assert_int_equal(add_box(world, SCREE_BODY_STATIC, 1.0f, 1.0f, 0.0f, 0.0f).index, gone.index);
			mover.position = (scree_vec){0.0f, 1.612f};
			mover.velocity = (scree_vec){0.0f, -1.0f};
			if (variants[k].other[0])
				OK(scree_world_move(world, round ? variants[k].device : variants[k].other));
		}
		scree_world_destroy(world);
	}
}

// A shape passes between two walls with a clearance of 1 mm. The rotated shape hits the walls. A search for the nearest
// collidable begins inside a wall.
static void tight_places(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_box(world, SCREE_BODY_STATIC, 5.0f, 1.0f, 0.0f, 2.001f);
	add_box(world, SCREE_BODY_STATIC, 5.0f, 1.0f, 0.0f, -2.001f);
	scree_shape shape = box_shape(1.0f, 1.0f);
	scree_query_result found;
	scree_pose pose = {{-10.0f, 0.0f}, {1.0f, 0.0f}};
	OK(scree_world_cast_shape(world, &shape, pose, (scree_vec){20.0f, 0.0f}, &found));
	assert_true(!found.hit);
	pose.rotation = scree_rot_make(0.01f);
	OK(scree_world_cast_shape(world, &shape, pose, (scree_vec){20.0f, 0.0f}, &found));
	assert_true(found.hit && !found.inside);
	NEAR(found.fraction, 0.2, 0.01);
	scree_probe probe = {.pose = {{0.0f, 0.5f}, {1.0f, 0.0f}}};
	OK(scree_world_find_nearest(world, NULL, &shape, &probe, 1, 1.0f, &found));
	assert_true(found.hit && found.inside && found.collidable.index == 1);
	NEAR(found.fraction, -0.499, 1e-4);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(all_at_one_point), cmocka_unit_test(edges_and_insides), cmocka_unit_test(ignores_what_is_gone),
	    cmocka_unit_test(tight_places),     cmocka_unit_test(all_devices_agree),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
