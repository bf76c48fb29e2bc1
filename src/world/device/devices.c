// SPDX-License-Identifier: MIT
// devices.c -- lists the devices, opens a device, and tests a device.
#include "world/device/devices.h"
#include "platform/error.h"
#include <string.h>

#ifdef SCREE_NO_OPENCL
static const char* const without_opencl =
    "This build has no OpenCL, because opencl-c-headers (Debian, Ubuntu) was missing.";
int opencl_devices(scree_device* devices, int capacity)
{
	(void)devices;
	(void)capacity;
	return 0;
}
const char* opencl_hint(void) { return without_opencl; }
scree_status opencl_open(const BackendOptions* options, Backend** backend)
{
	(void)options;
	*backend = NULL;
	return fail(SCREE_ERROR_NO_DEVICE, "%s", without_opencl);
}
scree_status opencl_test(const BackendOptions* options)
{
	(void)options;
	return fail(SCREE_ERROR_NO_DEVICE, "%s", without_opencl);
}
#endif

int devices_list(scree_device* devices, int capacity)
{
	int cpus = cpu_devices(devices, capacity);
	int left = capacity > cpus ? capacity - cpus : 0;
	return cpus + opencl_devices(left > 0 ? devices + cpus : NULL, left);
}

// Returns the part of a name such as "opencl:NAME" after the colon, or null.
static const char* part_of(const char* device) { return device[6] ? device + 7 : NULL; }

static BackendOptions options_of(const scree_world_def* def, TestWorlds* test)
{
	return (BackendOptions){.threads = def->threads,
	                        .lanes = def->lanes,
	                        .allow_unequal_bits = def->allow_unequal_bits,
	                        .timings = def->timings,
	                        .device_timeout = def->device_timeout,
	                        .opengl = def->opengl,
	                        .tasks = def->tasks,
	                        .test = test};
}

static scree_status open_named(BackendOptions* options, const char* device, Backend** backend)
{
	if (strncmp(device, "opencl", 6) != 0)
		return cpu_open(options, backend);
	options->device = part_of(device);
	return opencl_open(options, backend);
}

scree_status device_open(const scree_world_def* def, TestWorlds* test, Backend** backend)
{
	BackendOptions options = options_of(def, test);
	return open_named(&options, def->device, backend);
}

scree_status device_open_batch(const scree_world_def* def, TestWorlds* test, Backend* beside, Backend** backend)
{
	BackendOptions options = options_of(def, test);
	options.batch = true;
	options.beside = beside;
	return open_named(&options, def->device, backend);
}

scree_status device_open_gpu(const scree_world_def* def, TestWorlds* test, Backend** backend)
{
	BackendOptions options = options_of(def, test);
	options.gpu = true;
	options.allow_unequal_bits = false;
	return opencl_open(&options, backend);
}

scree_status device_test(const char* device, TestWorlds* test)
{
	BackendOptions options = {.device = part_of(device), .test = test};
	return opencl_test(&options);
}
