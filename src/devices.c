// SPDX-License-Identifier: MIT
// devices.c -- which devices there are, and the one that a world runs on.
#include "devices.h"
#include "check.h"
#include "definition.h"
#include <string.h>

#ifdef SCREE_NO_OPENCL
static const char* const without_opencl =
    "Scree was built without OpenCL: install its headers (Debian, Ubuntu: opencl-c-headers) and build again.";
int opencl_devices(scree_device* devices, int capacity)
{
	(void)devices;
	(void)capacity;
	return 0;
}
const char* opencl_remedy(void) { return without_opencl; }
scree_status opencl_open(const BackendOptions* options, Backend** backend)
{
	(void)options;
	*backend = NULL;
	return fail(SCREE_ERROR_NO_DEVICE, "%s", without_opencl);
}
#endif

static int list_devices(scree_device* devices, int capacity)
{
	int cpus = cpu_devices(devices, capacity);
	int left = capacity > cpus ? capacity - cpus : 0;
	return cpus + opencl_devices(left > 0 ? devices + cpus : NULL, left);
}

scree_status scree_devices_get_sized(scree_device* devices, size_t size, int capacity, int* count)
{
	const char* function = "scree_devices_get";
	TRY(check_list(function, "devices", devices, capacity, count));
	int there = list_devices(NULL, 0), listed = there < capacity ? there : capacity;
	if (listed > 0)
	{
		scree_device* known = scree_allocate((size_t)listed * sizeof *known);
		if (!known)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d devices", function, listed);
		list_devices(known, listed);
		for (int k = 0; k < listed; ++k)
			write_result((char*)devices + size * (size_t)k, size, known + k, sizeof *known);
		scree_release(known);
	}
	*count = there;
	return SCREE_OK;
}

const char* scree_opencl_remedy(void) { return opencl_devices(NULL, 0) > 0 ? "" : opencl_remedy(); }

scree_status check_device(Where at, const char* member, const char* device)
{
	if (!device)
		return refuse(SCREE_ERROR_INVALID, at, member, "is null");
	if (strcmp(device, "auto") == 0 || strcmp(device, "cpu") == 0 || strcmp(device, "opencl") == 0)
		return SCREE_OK;
	if (strncmp(device, "opencl:", 7) == 0 && device[7])
		return SCREE_OK;
	return refuse(
	    SCREE_ERROR_INVALID, at, member,
	    "is \"%.64s\", must be \"auto\", \"cpu\", \"opencl\" or \"opencl:NAME\" with a part of a device's name",
	    device);
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
