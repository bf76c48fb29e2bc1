// SPDX-License-Identifier: MIT
// second_device.h -- the device that worlds of tests move to, and a world that is worth moving.
#ifndef SECOND_DEVICE_H
#define SECOND_DEVICE_H
#include "support/make_bodies.h"

// Set-up: finds an OpenCL device that keeps equal bits; second_device is its name, empty when there is none.
int find_second_device(void** state);
extern char second_device[128];

#define NEEDS_SECOND_DEVICE() \
	if (!second_device[0])    \
	skip()

// A pyramid of boxes with a circle above, in motion after 20 steps.
scree_world* open_pile(const char* device, bool alone);

// The hash of the pile after some steps by one thread.
uint64_t hash_after(int steps);

#endif
