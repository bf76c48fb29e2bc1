// SPDX-License-Identifier: MIT
// test_auto.c -- checks that the device "auto" moves a world by measured times, and that moves do not change its state.
#include "support/environment.h"
#include "support/faulty_device.h"
#include "support/log_lines.h"
#include "support/second_device.h"
#include "world/device/open_async.h"
#include "world/world.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int forget_auto(void** state)
{
	set_environment("SCREE_AUTO", NULL);
	return release_log(state) || memory_is_released(state);
}

// Takes steps until the world tries the second device. Returns the number of steps.
static int run_to_trial(scree_world* world)
{
	int steps = 0;
	while (!world->auto_device.trial && steps < 100)
	{
		run_steps(world, 1);
		++steps;
	}
	assert_true(world->auto_device.trial);
	assert_string_equal(scree_world_get_device(world), second_device);
	return steps;
}

// A trial keeps the device with the shorter measured step. The test overwrites the measured times: in the first case
// the CPU is slower, then the other device.
static void trial_decides(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	set_environment("SCREE_AUTO", second_device);
	scree_world* world = open_pile("auto", false);
	int steps = run_to_trial(world);
	world->auto_device.meters[0].step = 1e6;
	run_steps(world, 30);
	assert_string_equal(scree_world_get_device(world), second_device);
	assert_false(world->auto_device.trial);
	assert_true(was_logged("the world moves to opencl:") && was_logged("ms a step, and 1000000.0000 ms on cpu"));

	// the next trial, on the CPU, begins when the steps since the last trial have taken long enough
	world->auto_device.spent = 1e9;
	run_steps(world, 1);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_true(world->auto_device.trial);
	world->auto_device.meters[1].step = 0.0;
	run_steps(world, 10);
	assert_string_equal(scree_world_get_device(world), second_device);
	assert_true(was_logged("the world does not stay on cpu"));
	assert_int_equal(world->auto_device.failures, 1);

	world->auto_device.spent = 1e9;
	run_steps(world, 1);
	world->auto_device.meters[1].step = 1e6;
	run_steps(world, 10);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_int_equal(world->auto_device.failures, 0);
	assert_true(hash_of(world) == hash_after(steps + 52));
	scree_world_destroy(world);
}

static void world_goes_back(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	set_environment("SCREE_AUTO", second_device);
	scree_world* world = open_pile("auto", false);
	int steps = run_to_trial(world);
	world->auto_device.meters[0].step = 0.0;
	run_steps(world, 20);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_true(was_logged("the world does not stay on opencl:"));

	// the failure and the cost of the trial are recorded: the next trial begins only after steps that take many times
	// as long as this trial
	assert_true(world->auto_device.cost > 0.0);
	assert_true(world->auto_device.failures == 1);
	assert_false(world->auto_device.trial);
	assert_true(hash_of(world) == hash_after(steps + 20));
	scree_world_destroy(world);
}

// No GPU is opened for a world that is so small that a GPU would not be faster.
static void small_world_stays(void** state)
{
	(void)state;
	scree_world* world = open_pile("auto", false);
	run_steps(world, 60);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_null(world->auto_device.opening);
	assert_null(world->auto_device.other);
	assert_int_equal(log_count, 0);
	assert_true(hash_of(world) == hash_after(60));
	scree_world_destroy(world);
}

static void other_is_missing(void** state)
{
	(void)state;
	set_environment("SCREE_AUTO", "opencl:no such device");
	scree_world* world = open_pile("auto", false);
	run_steps(world, 20);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_true(was_logged("scree_world_step: the world stays on the CPU: "));
	assert_int_equal(log_count, 1);
	scree_world_destroy(world);

	set_environment("SCREE_AUTO", "cpu");
	world = open_pile("auto", false);
	run_steps(world, 20);
	assert_int_equal(log_count, 1);
	scree_world_destroy(world);
}

// A device that fails while the world moves to it is not tried again.
static void other_falls(void** state)
{
	(void)state;
	scree_world* world = open_pile("auto", true);
	run_steps(world, 10);
	BackendOptions options = {.threads = 1};
	Backend* to;
	OK(cpu_open(&options, &to));
	BackendFunctions f = faulty_functions(to);
	to->f = &f;
	to->distant = true;
	device_fault = (Fault){
	    .calls = FAULT_RESIZE | FAULT_COPY, .calls_left = 20, .lasts = true, .status = SCREE_ERROR_OUT_OF_MEMORY};
	snprintf(world->auto_device.named, sizeof world->auto_device.named, "%s", "opencl:X");
	world->auto_device.other = to;
	run_steps(world, 10);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_true(world->auto_device.alone && !world->auto_device.trial && !world->auto_device.other);
	assert_true(was_logged("scree_world_step: the world stays on cpu: the device has no memory left"));
	assert_true(hash_of(world) == hash_after(20));
	scree_world_destroy(world);
}

// A move by the user ends the automatic choice, and a move to "auto" starts it again.
static void user_decides(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	set_environment("SCREE_AUTO", second_device);
	scree_world* world = open_pile("auto", false);
	int steps = run_to_trial(world);
	OK(scree_world_move(world, "cpu"));
	assert_false(world->auto_device.on);
	assert_null(world->auto_device.other);
	run_steps(world, 20);
	assert_string_equal(scree_world_get_device(world), "cpu");
	OK(scree_world_move(world, "auto"));
	OK(scree_world_move(world, "auto"));
	steps += run_to_trial(world);
	OK(scree_world_move(world, second_device));
	assert_false(world->auto_device.on);
	run_steps(world, 20);
	assert_string_equal(scree_world_get_device(world), second_device);

	// a world on the second device also tries the CPU
	OK(scree_world_move(world, "auto"));
	while (!world->auto_device.trial && steps < 1000)
	{
		run_steps(world, 1);
		++steps;
	}
	world->auto_device.meters[1].step = 1e6;
	run_steps(world, 10);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_true(hash_of(world) == hash_after(steps + 50));
	scree_world_destroy(world);
}

// A world may be destroyed, or moved by the user, while a device is being opened for it.
static void opening_is_waited_for(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	for (int moved = 0; moved < 2; ++moved)
	{
		scree_world* world = open_pile("auto", false);
		world->auto_device.opening = async_open_begin(&world->def, second_device, world->auto_device.test);
		assert_non_null(world->auto_device.opening);
		if (moved)
			OK(scree_world_move(world, "cpu"));
		scree_world_destroy(world);
		assert_int_equal(scree_memory(), 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(trial_decides, keep_log, forget_auto),
	    cmocka_unit_test_setup_teardown(world_goes_back, keep_log, forget_auto),
	    cmocka_unit_test_setup_teardown(small_world_stays, keep_log, forget_auto),
	    cmocka_unit_test_setup_teardown(other_is_missing, keep_log, forget_auto),
	    cmocka_unit_test_setup_teardown(other_falls, keep_log, forget_auto),
	    cmocka_unit_test_setup_teardown(user_decides, keep_log, forget_auto),
	    cmocka_unit_test(opening_is_waited_for),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
