// SPDX-License-Identifier: MIT
// device_choice.c -- lists and tests the devices, and moves a world to another device.
#include "api/world/device_test.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/device/auto.h"
#include "world/device/devices.h"
#include "world/device/migrate.h"
#include "world/failure.h"
#include "world/objects/reports.h"
#include "world/record/api_calls.h"
#include "world/recovery/recovery.h"
#include "world/world.h"
#include <string.h>

scree_status api_devices_get_sized(scree_device* devices, size_t size, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_devices_get";
	TRY(check_list(function, "devices", devices, capacity, count));
	int there = devices_list(NULL, 0), listed = there < capacity ? there : capacity;
	if (listed > 0)
	{
		scree_device* known = scree_allocate((size_t)listed * sizeof *known);
		if (!known)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d devices", function, listed);
		devices_list(known, listed);
		for (int k = 0; k < listed; ++k)
			write_result((char*)devices + size * (size_t)k, size, known + k, sizeof *known);
		scree_release(known);
	}
	*count = there;
	return SCREE_OK;
}

// Drivers start threads at the first call, which keep the mode of the caller.
const char* scree_opencl_hint(void)
{
	FLOAT_MODE_HERE;
	return opencl_devices(NULL, 0) > 0 ? "" : opencl_hint();
}

scree_status api_device_test(const char* device)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_device_test";
	TRY(check_device((ArgumentPlace){function, "device", ALONE}, "", device));
	if (strcmp(device, "auto") == 0)
		return fail(SCREE_ERROR_INVALID, "%s: device is \"auto\", must be \"cpu\", \"opencl\" or \"opencl:NAME\"",
		            function);
#ifndef SCREE_SMALL
	TRY(cpu_self_test(function));
#endif
	return strcmp(device, "cpu") == 0 ? SCREE_OK : device_test(device, TEST_WORLDS);
}

scree_status api_world_move(scree_world* world, const char* device)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_move";
	TRY(world_check(world, function));
	TRY(check_device((ArgumentPlace){function, "device", ALONE}, "", device));
	if (strcmp(device, "auto") == 0 && auto_is_cpu(world))
		device = "cpu";
	if (strcmp(device, "auto") == 0)
	{
		auto_open(world, TEST_WORLDS);
		return SCREE_OK;
	}
	if (strcmp(device, world->device) != 0)
	{
		TRY(reports_fetch(world)); // a move does not copy the events, so they are read before it
		TRY(recovery_prepare(world, function));
		scree_world_def def = world->def;
		def.device = device;
		Backend *from = world->backend, *to;
		TRY(device_open(&def, TEST_WORLDS, &to));
		scree_status status = world_move(world, to);
		Backend* left = status == SCREE_OK ? from : to;
		left->f->close(left);
		TRY(status);
	}
	auto_close(world);
	return SCREE_OK;
}
