// SPDX-License-Identifier: MIT
// second_device.h -- finds a device to which tests move their worlds, and creates a world for such moves.
#ifndef SECOND_DEVICE_H
#define SECOND_DEVICE_H
#include "support/make_bodies.h"

// Set-up: finds an OpenCL device with equal bits and writes its name to second_device. Without such a device,
// second_device stays empty.
int find_second_device(void** state);
extern char second_device[128];

#define NEEDS_SECOND_DEVICE() \
	if (!second_device[0])    \
	skip()

// Opens a world with a pyramid of boxes and a falling circle. The bodies still move after 20 steps. The world has one
// thread if alone is true, otherwise two threads.
scree_world* open_pile(const char* device, bool alone);

// Returns the hash of this world after some steps on the CPU with one thread.
uint64_t hash_after(int steps);

#endif
