// SPDX-License-Identifier: MIT
// devices.c -- lists the devices, and opens a device.
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
#endif

int devices_list(scree_device* devices, int capacity)
{
	int cpus = cpu_devices(devices, capacity);
	int left = capacity > cpus ? capacity - cpus : 0;
	return cpus + opencl_devices(left > 0 ? devices + cpus : NULL, left);
}

scree_status device_open(const scree_world_def* def, Backend** backend)
{
	BackendOptions options = {.threads = def->threads,
	                          .lanes = def->lanes,
	                          .allow_unequal_bits = def->allow_unequal_bits,
	                          .timings = def->timings,
	                          .opengl = def->opengl};
	if (strncmp(def->device, "opencl", 6) != 0)
		return cpu_open(&options, backend);
	options.device = def->device[6] ? def->device + 7 : NULL;
	return opencl_open(&options, backend);
}

scree_status device_open_gpu(const scree_world_def* def, Backend** backend)
{
	BackendOptions options = {.timings = def->timings, .gpu = true, .opengl = def->opengl};
	return opencl_open(&options, backend);
}
