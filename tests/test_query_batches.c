// SPDX-License-Identifier: MIT
// test_query_batches.c -- checks large batches of queries, and batches whose items have arbitrary bits.
#include "support/random_queries.h"
#include "support/scenarios.h"
#include "tools/common/byte_hash.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define APPROVAL 500

// A GPU processes a large batch in parts. The results must equal those of small batches. If an item near the end is
// bad, the call must leave all results unchanged.
static void large_batches(void** state)
{
	(void)state;
	enum
	{
		MANY = 400001,
		FEW = 50000
	};
	scree_ray* rays = malloc(MANY * sizeof *rays);
	scree_query_result* found = malloc(2 * MANY * sizeof *found);
	scree_query_result* large = found + MANY;
	uint64_t seed = 5;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	for (int k = 0; k < MANY; ++k)
		rays[k] = (scree_ray){.origin = random_pose(&seed, (scree_vec){5.0f, 5.0f}, 8.0f).position,
		                      .translation = random_path(&seed, 4.0f)};
	for (int k = 0; k < count; ++k)
	{
		scree_world* world = open_default_variant(variants + k);
		for (int n = 0; n < 100; ++n)
			add_box(world, SCREE_BODY_STATIC, 0.2f, 0.4f, (float)(n % 10), (float)(n / 10));
		for (int n = 0; n < MANY && k == 0; n += FEW)
			OK(scree_world_cast_rays(world, NULL, rays + n, MANY - n < FEW ? MANY - n : FEW, found + n));
		memset(large, 0x5a, MANY * sizeof *large);
		const float good = rays[MANY - 2].translation.y;
		rays[MANY - 2].translation.y = (float)NAN;
		assert_int_equal(scree_world_cast_rays(world, NULL, rays, MANY, large), SCREE_ERROR_INVALID);
		assert_non_null(strstr(scree_error(), "rays[399999]"));
		for (size_t b = 0; b < MANY * sizeof *large; ++b)
			if (((unsigned char*)large)[b] != 0x5a)
				fail_msg("%s wrote an answer", variants[k].name);
		rays[MANY - 2].translation.y = good;
		OK(scree_world_cast_rays(world, NULL, rays, MANY, large));
		if (memcmp(found, large, MANY * sizeof *found) != 0)
			fail_msg("other answers on %s", variants[k].name);
		scree_world_destroy(world);
	}
	free(rays);
	free(found);
}

// Returns a float with arbitrary bits. Special values such as NaN, infinity and -0 are frequent.
static float any_float(uint64_t* seed)
{
	static const uint32_t odd[] = {0x7fc00000, 0xffc00000, 0x7f800000, 0xff800000,
	                               0x7f7fffff, 0x80000000, 1,          0x7f800001};
	uint32_t bits = (uint32_t)random_below(seed, 1 << 30) << 2;
	float x;
	switch (random_below(seed, 4))
	{
	case 0:
		bits = odd[random_below(seed, 8)];
		break;
	case 1:
		break;
	default:
		return random_between(seed, -10.0f, 10.0f);
	}
	memcpy(&x, &bits, sizeof x);
	return x;
}

// Calls queries with items of arbitrary bits. Each call must be refused or return results, and no device may read
// beyond its pools. Returns a hash of refusals and results.
static uint64_t ask_bits(scree_world* world)
{
	static scree_ray rays[APPROVAL];
	static scree_probe probes[APPROVAL];
	static scree_query_result found[APPROVAL];
	uint64_t seed = 6, hash = HASH_BEGIN;
	scree_shape shape = box_shape(0.4f, 0.1f);
	scree_query_def def = scree_query_def_default();
	scree_query_results list;
	for (int turn = 0; turn < (quick() ? 50 : 500); ++turn)
	{
		int count = 1 + random_below(&seed, turn % 2 ? 4 : APPROVAL), refused = 0;
		def.any = turn % 3 == 0;
		for (int k = 0; k < count; ++k)
		{
			float x[13];
			for (int i = 0; i < 13; ++i)
				x[i] = any_float(&seed);
			rays[k] =
			    (scree_ray){.origin = {x[0], x[1]}, .translation = {x[2], x[3]}, .radius = turn % 2 ? 0.0f : x[4]};
			probes[k] = (scree_probe){.pose = {{x[5], x[6]}, scree_rot_make(x[7])}, .translation = {x[8], x[9]}};
			if (turn % 5 == 0)
				probes[k].pose.rotation = (scree_rot){x[10], x[11]};
		}
		memset(found, 0, sizeof found);
		refused += scree_world_cast_rays(world, &def, rays, count, found) != SCREE_OK;
		refused = 2 * refused +
		          (scree_world_cast_shapes(world, &def, turn % 2 ? &shape : NULL, probes, count, found) != SCREE_OK);
		hash = hash_bytes(hash, found, sizeof found);
		def.any = false;
		refused = 2 * refused + (scree_world_find_nearest(world, &def, turn % 2 ? &shape : NULL, probes, count, 3.0f,
		                                                  found) != SCREE_OK);
		hash = hash_bytes(hash, found, sizeof found);
		refused = 2 * refused + (scree_world_list_rays(world, &def, rays, count, &list) != SCREE_OK);
		refused = 2 * refused + (scree_world_list_shapes(world, &def, &shape, probes, count, &list) != SCREE_OK);
		hash = hash_bytes(hash, &refused, sizeof refused);
	}
	return hash;
}

static uint64_t answers_to_bits(const Variant* variant)
{
	scree_world* world = open_default_variant(variant);
	add_floor(world);
	for (int n = 0; n < 77; ++n) // with 77 boxes, some nodes of the tree have fewer than 8 children
		add_box(world, n % 3 ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC, 0.3f, 0.2f, (float)(n % 9), (float)(n / 9));
	run_steps(world, 1);
	uint64_t answers = ask_bits(world);
	scree_world_destroy(world);
	return answers;
}

static void any_bits(void** state)
{
	(void)state;
	check_equal(answers_to_bits);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(large_batches),
	    cmocka_unit_test(any_bits),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
