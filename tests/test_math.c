// SPDX-License-Identifier: MIT
// test_math.c -- checks the arithmetic of scree_math.h against its formulas, and against the library; its random numbers.
#include "support/make_bodies.h"
#include <math.h>
#include <scree/scree_math.h>
#include <string.h>

#define NEAR_VEC(v, a, b)        \
	do                           \
	{                            \
		scree_vec near_v = v;    \
		NEAR(near_v.x, a, 1e-6); \
		NEAR(near_v.y, b, 1e-6); \
	} while (0)

#define RESULT_BITS 0x04580ecau // hash of the results of bits_do_not_depend_on_the_compiler

static const scree_vec a = {3.0f, 4.0f}, b = {-1.0f, 2.0f};

static void vectors(void** state)
{
	(void)state;
	NEAR_VEC(scree_vec_add(a, b), 2.0, 6.0);
	NEAR_VEC(scree_vec_sub(a, b), 4.0, 2.0);
	NEAR_VEC(scree_vec_negate(a), -3.0, -4.0);
	NEAR_VEC(scree_vec_scale(2.0f, a), 6.0, 8.0);
	NEAR_VEC(scree_vec_turn(a), -4.0, 3.0);
	NEAR_VEC(scree_vec_lerp(a, b, 0.25f), 2.0, 3.5);
	NEAR_VEC(scree_vec_normalize(a), 0.6, 0.8);
	NEAR_VEC(scree_vec_normalize(scree_vec_make(0.0f, 0.0f)), 0.0, 0.0);
	NEAR(scree_vec_dot(a, b), 5.0, 0.0);
	NEAR(scree_vec_cross(a, b), 10.0, 0.0);
	NEAR(scree_vec_length(a), 5.0, 0.0);
	NEAR(scree_vec_distance(a, b), sqrt(20.0), 1e-6);
	// neither tiny nor huge vectors lose their length, because squares are double
	NEAR(scree_vec_length(scree_vec_make(3e-30f, 4e-30f)) / 5e-30, 1.0, 1e-6);
	NEAR(scree_vec_length(scree_vec_make(3e30f, 4e30f)) / 5e30, 1.0, 1e-6);
	NEAR_VEC(scree_vec_normalize(scree_vec_make(3e-40f, 4e-40f)), 0.6, 0.8);
	assert_true(isnan(scree_vec_length(scree_vec_make(NAN, 0.0f))));
	// the ends of an interpolation are exact
	assert_true(scree_lerp(0.1f, 1e6f, 0.0f) == 0.1f && scree_lerp(0.1f, 1e6f, 1.0f) == 1e6f);
}

static void rotations_and_poses(void** state)
{
	(void)state;
	const scree_rot q = scree_rot_make(0.7f), r = scree_rot_make(-0.2f);
	NEAR(scree_rot_get_angle(scree_rot_multiply(q, r)), 0.5, 1e-6);
	NEAR(scree_rot_get_angle(scree_rot_invert(q)), -0.7, 1e-6);
	NEAR(scree_rot_get_angle(scree_rot_lerp(q, r, 0.5f)), 0.25, 1e-6);
	NEAR_VEC(scree_rot_apply(q, a), 3.0 * cos(0.7) - 4.0 * sin(0.7), 3.0 * sin(0.7) + 4.0 * cos(0.7));
	NEAR_VEC(scree_rot_apply_inverse(q, scree_rot_apply(q, a)), 3.0, 4.0);
	const scree_pose outer = scree_pose_make(1.0f, 2.0f, 0.7f), inner = scree_pose_make(-3.0f, 0.5f, 1.1f);
	NEAR_VEC(scree_pose_apply_inverse(outer, scree_pose_apply(outer, a)), 3.0, 4.0);
	const scree_vec twice = scree_pose_apply(outer, scree_pose_apply(inner, a));
	NEAR_VEC(scree_pose_apply(scree_pose_multiply(outer, inner), a), twice.x, twice.y);
	NEAR_VEC(scree_pose_apply(scree_pose_invert(outer), scree_pose_apply(outer, a)), 3.0, 4.0);
	const scree_pose half = scree_pose_lerp(outer, inner, 0.5f);
	NEAR_VEC(half.position, -1.0, 1.25);
	NEAR(scree_rot_get_angle(half.rotation), 0.9, 1e-6);
	const scree_pose upright = scree_pose_make(1.0f, 2.0f, 0.0f);
	assert_true(upright.rotation.c == 1.0f && upright.rotation.s == 0.0f);
}

// The library converts points as the header does, to the rounding of its own arithmetic, which is in float.
static void points_are_those_of_the_library(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	const scree_pose pose = scree_pose_make(5.0f, -3.0f, 2.5f);
	scree_body body;
	OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, pose, 0.5f, 0.5f, 0, &body));
	scree_vec point, local;
	OK(scree_body_get_world_point(world, body, a, &point));
	const scree_vec here = scree_pose_apply(pose, a);
	NEAR_VEC(here, (double)point.x, (double)point.y);
	OK(scree_body_get_local_point(world, body, here, &local));
	NEAR_VEC(local, 3.0, 4.0);
	scree_world_destroy(world);
}

// Bits of the results for 1,000 vectors: FNV-1a of their bytes, which a compiler that fused products and sums would change.
static void bits_do_not_depend_on_the_compiler(void** state)
{
	(void)state;
	uint32_t seed = 1, hash = 2166136261u;
	for (int k = 0; k < 1000; ++k)
	{
		float x[6];
		for (int i = 0; i < 6; ++i)
		{
			seed = seed * 1664525u + 1013904223u;
			x[i] = (float)(seed >> 8) / 1e4f - 800.0f;
		}
		const scree_pose pose = {{x[0], x[1]}, scree_rot_make(x[2])};
		const scree_vec v = scree_pose_apply(pose, scree_vec_make(x[3], x[4]));
		const float results[] = {v.x,
		                         v.y,
		                         scree_vec_dot(v, pose.position),
		                         scree_vec_cross(v, pose.position),
		                         scree_vec_length(v),
		                         scree_lerp(x[3], x[4], 0.37f),
		                         scree_vec_normalize(v).x,
		                         scree_rot_multiply(pose.rotation, scree_rot_make(x[5])).s};
		unsigned char bytes[sizeof results];
		memcpy(bytes, results, sizeof results);
		for (size_t i = 0; i < sizeof bytes; ++i)
			hash = (hash ^ bytes[i]) * 16777619u;
	}
	assert_int_equal(hash, RESULT_BITS);
}

// Answers of the reference implementation, Random123, for Philox4x32-10 (its file kat_vectors): counter, key, result.
static void random_numbers_are_those_of_the_reference(void** state)
{
	(void)state;
	static const struct
	{
		uint64_t seed, world;
		uint32_t step, index, words[4];
	} known[] = {{0, 0, 0, 0, {0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u}},
	             {UINT64_MAX, UINT64_MAX, UINT32_MAX, UINT32_MAX, {0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu}},
	             {0x299f31d0a4093822u,
	              0x0370734413198a2eu,
	              0x85a308d3u,
	              0x243f6a88u,
	              {0xd16cfe09u, 0x94fdccebu, 0x5001e420u, 0x24126ea1u}}};
	for (size_t k = 0; k < sizeof known / sizeof *known; ++k)
	{
		const scree_random r = scree_random_make(known[k].seed, known[k].world, known[k].step, known[k].index);
		assert_memory_equal(r.words, known[k].words, sizeof r.words);
	}
	assert_true(scree_random_between(0, -2.0f, 6.0f) == -2.0f && scree_random_between(1u << 31, -2.0f, 6.0f) == 2.0f);
	assert_true(scree_random_between(UINT32_MAX, 0.0f, 1.0f) < 1.0f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(vectors),
	    cmocka_unit_test(rotations_and_poses),
	    cmocka_unit_test(points_are_those_of_the_library),
	    cmocka_unit_test(bits_do_not_depend_on_the_compiler),
	    cmocka_unit_test(random_numbers_are_those_of_the_reference),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
