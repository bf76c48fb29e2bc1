// SPDX-License-Identifier: MIT
// moving.h -- helpers for tests of worlds that move: a world, the device to move it to, and a device that fails.
#ifndef MOVING_H
#define MOVING_H
#include "world/world.h" // before cmocka, which makes a macro of fail
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support.h"
#include <stdio.h>

// the name of an OpenCL device that keeps equal bits, empty when there is none
static char other[128];

static inline int find_other(void** state)
{
	(void)state;
	scree_device devices[MAX_WAYS];
	int count;
	OK(scree_devices_get(devices, MAX_WAYS, &count));
	for (int k = 1; k < count && k < MAX_WAYS && !other[0]; ++k)
		if (devices[k].equal_bits)
			snprintf(other, sizeof other, "%s", devices[k].name);
	return 0;
}

#define NEEDS_OTHER() \
	if (!other[0])    \
	skip()

// A pyramid of boxes with a circle above, in motion after 20 steps.
static inline scree_world* open_pile(const char* device, bool alone)
{
	scree_world_def def = scree_world_def_default();
	def.device = device;
	def.threads = alone ? 1 : 2;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	add_floor(world);
	for (int row = 0; row < 8; ++row)
		for (int k = 0; k < 8 - row; ++k)
			add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.5f, 1.05f * (float)k + 0.5f * (float)row, 0.5f + (float)row);
	scree_attribute_def circle = surface_of(circle_shape(0.4f));
	circle.restitution = 0.5f;
	add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &circle), 4.0f, 12.0f, 0.0f);
	return world;
}

static inline uint64_t hash_after(int steps)
{
	scree_world* world = open_pile("cpu", true);
	run_steps(world, steps);
	uint64_t hash = hash_of(world);
	scree_world_destroy(world);
	return hash;
}

static const BackendFunctions* real; // functions of the CPU
static int calls_left;               // calls until the device fails
static scree_status call_status;

static inline scree_status call_fails(void)
{
	return calls_left-- > 0 ? SCREE_OK : (fail)(call_status, "the device has fallen");
}

static inline scree_status faulty_resize(Backend* b, Per per, int capacity)
{
	scree_status status = call_fails();
	return status ? status : real->resize(b, per, capacity);
}

static inline scree_status faulty_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	scree_status status = call_fails();
	return status ? status : real->write(b, pool, first, count, items);
}

static inline scree_status faulty_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	scree_status status = call_fails();
	return status ? status : real->read(b, pool, first, count, items);
}

// A CPU that calls like these reach, as if it were far away.
static inline BackendFunctions far_away(Backend* b, bool faulty)
{
	real = b->f;
	BackendFunctions f = *real;
	f.address = NULL;
	f.spare = NULL;
	if (faulty)
	{
		f.resize = faulty_resize;
		f.write = faulty_write;
		f.read = faulty_read;
	}
	return f;
}

#endif
