// SPDX-License-Identifier: MIT
// test_clock.c -- checks the clock that divides frames into steps, without a world.
//
// Formula: after frames of t_k seconds, steps = floor(sum t_k / dt) and alpha = sum t_k / dt - steps.
#include "support/checks.h"
#include <float.h>
#include <math.h>

#define DT (1.0f / 60.0f)

// Frames of any rate give the steps of their sum, after 1 s and after hours.
static void steps_follow_the_time(void** state)
{
	(void)state;
	static const double rates[] = {24.0, 59.94, 60.0, 75.0, 120.0, 144.0, 165.0, 1000.0};
	for (size_t k = 0; k < sizeof rates / sizeof *rates; ++k)
	{
		scree_clock clock = scree_clock_default(DT);
		int64_t steps = 0;
		for (int frame = 1; frame <= 1000000; ++frame)
		{
			steps += scree_clock_advance(&clock, 1.0 / rates[k]);
			assert_true(clock.alpha >= 0.0f && clock.alpha < 1.0f && clock.rest >= 0.0 && clock.rest < (double)DT);
			assert_true(clock.dropped == 0.0);
			if (frame % 99991 == 0)
				NEAR((double)steps + clock.rest / (double)DT, frame / rates[k] / (double)DT, 1e-6);
		}
	}
}

static void fractions_are_steps(void** state)
{
	(void)state;
	scree_clock clock = scree_clock_default(0.25f);
	assert_true(clock.dt == 0.25f && clock.time_scale == 1.0f && clock.most_steps == 8 && !clock.paused);
	assert_int_equal(scree_clock_advance(&clock, 0.125), 0);
	assert_true(clock.alpha == 0.5f);
	assert_int_equal(scree_clock_advance(&clock, 0.125), 1);
	assert_true(clock.alpha == 0.0f);
	assert_int_equal(scree_clock_advance(&clock, 1.0625), 4);
	assert_true(clock.alpha == 0.25f && clock.rest == 0.0625);
}

static void slow_motion_and_pause(void** state)
{
	(void)state;
	scree_clock clock = scree_clock_default(0.25f);
	clock.time_scale = 0.25f;
	assert_int_equal(scree_clock_advance(&clock, 0.75), 0);
	assert_true(clock.alpha == 0.75f);
	clock.paused = true;
	for (int k = 0; k < 100; ++k)
		assert_int_equal(scree_clock_advance(&clock, 10.0), 0);
	assert_true(clock.alpha == 0.75f && clock.dropped == 0.0);
	clock.paused = false;
	assert_int_equal(scree_clock_advance(&clock, 0.25), 1);
	assert_true(clock.alpha == 0.0f);
	clock.time_scale = 0.0f;
	assert_int_equal(scree_clock_advance(&clock, 10.0), 0);
	assert_true(clock.alpha == 0.0f);
	clock.time_scale = 2.0f;
	assert_int_equal(scree_clock_advance(&clock, 0.25), 2);
}

static void long_frames_are_cut(void** state)
{
	(void)state;
	scree_clock clock = scree_clock_default(0.25f);
	assert_int_equal(scree_clock_advance(&clock, 2.0), 8);
	assert_true(clock.dropped == 0.0);
	assert_int_equal(scree_clock_advance(&clock, 3.125), 8);
	assert_true(clock.dropped == 1.0 && clock.alpha == 0.5f);
	assert_int_equal(scree_clock_advance(&clock, 0.125), 1);
	assert_true(clock.dropped == 0.0);
	clock.most_steps = 1;
	assert_int_equal(scree_clock_advance(&clock, 100.0), 1);
	assert_true(clock.dropped == 99.75);
	clock.most_steps = -3;
	assert_int_equal(scree_clock_advance(&clock, 0.5), 1);
}

// No number leads to a wrong count: NaN and negative times are 0, huge ones are cut.
static void any_number_is_handled(void** state)
{
	(void)state;
	static const double times[] = {NAN, -1.0, -INFINITY, 0.0, -0.0, 5e-324, 1e30, DBL_MAX, INFINITY};
	static const float scales[] = {1.0f, 0.0f, -1.0f, NAN, INFINITY, FLT_MAX, 1e-45f};
	static const float lengths[] = {DT, 1e-9f, 1.0f, 0.0f, -1.0f, NAN, FLT_MIN, 1e-45f, INFINITY};
	static const double rests[] = {0.0, NAN, -5.0, INFINITY, 1e300};
	for (size_t k = 0; k < sizeof times / sizeof *times; ++k)
		for (size_t s = 0; s < sizeof scales / sizeof *scales; ++s)
			for (size_t d = 0; d < sizeof lengths / sizeof *lengths; ++d)
				for (size_t r = 0; r < sizeof rests / sizeof *rests; ++r)
				{
					scree_clock clock = scree_clock_default(lengths[d]);
					clock.time_scale = scales[s];
					clock.rest = rests[r];
					int steps = scree_clock_advance(&clock, times[k]);
					assert_true(steps >= 0 && steps <= clock.most_steps);
					assert_true(clock.alpha >= 0.0f && clock.alpha < 1.0f);
					assert_true(clock.dropped >= 0.0);
					assert_true(!(lengths[d] >= 1e-9f && lengths[d] <= 1.0f) || clock.rest >= 0.0);
				}
	scree_clock clock = scree_clock_default(DT);
	assert_int_equal(scree_clock_advance(&clock, INFINITY), 8);
	assert_true(clock.alpha == 0.0f && isinf(clock.dropped) && clock.rest == 0.0);
	assert_int_equal(scree_clock_advance(&clock, 1.5 * (double)DT), 1);
	assert_int_equal(scree_clock_advance(NULL, 1.0), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(steps_follow_the_time), cmocka_unit_test(fractions_are_steps),
	    cmocka_unit_test(slow_motion_and_pause), cmocka_unit_test(long_frames_are_cut),
	    cmocka_unit_test(any_number_is_handled),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
