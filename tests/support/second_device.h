// SPDX-License-Identifier: MIT
// second_device.h -- finds a device to which tests move their worlds, and creates a world for such moves.
#ifndef SECOND_DEVICE_H
#define SECOND_DEVICE_H
#include "support/make_bodies.h"

// Set-up: finds an OpenCL device whose results have the same bits as those of the CPU, and writes its name to
// second_device. Without such a device, second_device stays empty.
int find_second_device(void** state);
extern char second_device[128];

#define NEEDS_SECOND_DEVICE() \
	if (!second_device[0])    \
	skip()

// Opens a world with a pyramid of boxes and a falling circle. The bodies still move after 20 steps. alone: true for a
// world with one thread, false for two threads.
scree_world* open_pile(const char* device, bool alone);

// Returns the hash of the world of open_pile after some steps on the CPU with one thread.
uint64_t hash_after(int steps);

#endif
