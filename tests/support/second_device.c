// SPDX-License-Identifier: MIT
// second_device.c -- finds a device to which tests move their worlds, and creates a world for such moves.
#include "support/second_device.h"
#include <stdio.h>

#define MOST_DEVICES 32

char second_device[128];

int find_second_device(void** state)
{
	(void)state;
	scree_device devices[MOST_DEVICES];
	int count;
	OK(scree_devices_get(devices, MOST_DEVICES, &count));
	for (int k = 1; k < count && k < MOST_DEVICES && !second_device[0]; ++k)
		if (devices[k].equal_bits)
			snprintf(second_device, sizeof second_device, "%s", devices[k].name);
	return 0;
}

scree_world* open_pile(const char* device, bool alone)
{
	scree_world* world = open_world_on(device, alone ? 1 : 2, (float)-G);
	add_floor(world);
	for (int row = 0; row < 8; ++row)
		for (int k = 0; k < 8 - row; ++k)
			add_crate(world, SCREE_BODY_DYNAMIC, 1.05f * (float)k + 0.5f * (float)row, 0.5f + (float)row);
	scree_attribute_def circle = surface_of(circle_shape(0.4f));
	circle.restitution = 0.5f;
	add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &circle), 4.0f, 12.0f, 0.0f);
	return world;
}

uint64_t hash_after(int steps)
{
	scree_world* world = open_pile("cpu", true);
	run_steps(world, steps);
	uint64_t hash = hash_of(world);
	scree_world_destroy(world);
	return hash;
}
