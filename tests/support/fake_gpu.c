// SPDX-License-Identifier: MIT
// fake_gpu.c -- turns the CPU of a world into a device that a test lets fail.
#include "support/fake_gpu.h"
#include "support/faulty_device.h"
#include "world/world.h"

static BackendFunctions functions;

void become_fake_gpu(scree_world* world)
{
	device_fault = (Fault){.calls_left = -1};
	functions = faulty_functions(world->backend);
	world->backend->f = &functions;
	world->backend->threads = 0; // as on an OpenCL device
}

scree_world* open_on_fake_gpu(int recovery_interval)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 2;
	def.recovery_interval = recovery_interval;
	scree_world* world = create_world(&def);
	become_fake_gpu(world);
	return world;
}

void fake_gpu_falls(void)
{
	device_fault = (Fault){.calls = FAULT_RESIZE | FAULT_COPY | FAULT_WORK,
	                       .calls_left = 0,
	                       .lasts = true,
	                       .status = SCREE_ERROR_DEVICE_FAILED};
}
