// SPDX-License-Identifier: MIT
// test_equal_devices.c -- checks that OpenCL devices with one name have numbers, and that worlds run on each of them.
//
// PoCL lists its device as often as the variable POCL_DEVICES names it.
#include "support/environment.h"
#include "support/second_device.h"
#include <stdio.h>
#include <string.h>

#define SHORT 100 // characters of a name of PoCL's device, so that others fit around it

static char first[128]; // name of the first of the equal devices; empty: PoCL has none

static int begin(void** state)
{
	(void)state;
	scree_device devices[32];
	int count;
	set_environment("POCL_DEVICES", "pthread pthread pthread");
	OK(scree_devices_get(devices, 32, &count));
	for (int k = 1; k < count && k < 32 && !first[0]; ++k)
		if (devices[k].equal_bits && strstr(devices[k].driver, "Portable Computing Language"))
			snprintf(first, sizeof first, "%.*s", SHORT, devices[k].name);
	return 0;
}

#define NEEDS_EQUAL_DEVICES() \
	if (!first[0])            \
	skip()

static scree_status open_as(const char* device, scree_world** world)
{
	scree_world_def def = scree_world_def_default();
	def.device = device;
	return scree_world_create(&def, world);
}

// Checks that a world that is created on `device` runs on one with the name `expected`.
static void runs_on(const char* device, const char* expected)
{
	scree_world* world;
	OK(open_as(device, &world));
	assert_string_equal(scree_world_get_device(world), expected);
	scree_world_destroy(world);
}

static void numbers_choose_among_equal_devices(void** state)
{
	(void)state;
	NEEDS_EQUAL_DEVICES();
	char second[160], third[160], name[160];
	scree_world* world;
	snprintf(second, sizeof second, "%s #2", first);
	snprintf(third, sizeof third, "%s #3", first);
	runs_on(first, first);
	runs_on(second, second);
	runs_on(third, third);
	runs_on("opencl:Portable Computing#3", third);
	runs_on("opencl:PTHREAD #2", second);
	snprintf(name, sizeof name, "%s #1", first);
	runs_on(name, first);
	const char* absent[] = {"opencl:pthread #4", "opencl:pthread #0", "opencl:pthread #",
	                        "opencl:pthread #99999999999"};
	for (int k = 0; k < 4; ++k)
	{
		assert_int_equal(open_as(absent[k], &world), SCREE_ERROR_NO_DEVICE);
		assert_non_null(strstr(scree_error(), absent[k] + strlen("opencl:")));
	}
}

static void each_listed_name_is_its_device(void** state)
{
	(void)state;
	scree_device devices[32];
	int count;
	OK(scree_devices_get(devices, 32, &count));
	for (int k = 0; k < count && k < 32; ++k)
	{
		for (int other = 0; other < k; ++other)
			assert_string_not_equal(devices[k].name, devices[other].name);
		if (devices[k].equal_bits)
			runs_on(devices[k].name, devices[k].name);
	}
}

static void worlds_move_between_equal_devices(void** state)
{
	(void)state;
	NEEDS_EQUAL_DEVICES();
	char second[160];
	snprintf(second, sizeof second, "%s #2", first);
	scree_world* world = open_pile(first, true);
	run_steps(world, 10);
	OK(scree_world_move(world, second));
	assert_string_equal(scree_world_get_device(world), second);
	run_steps(world, 10);
	assert_int_equal(hash_of(world), hash_after(20));
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(numbers_choose_among_equal_devices),
	    cmocka_unit_test(each_listed_name_is_its_device),
	    cmocka_unit_test(worlds_move_between_equal_devices),
	};
	return cmocka_run_group_tests(tests, begin, NULL);
}
