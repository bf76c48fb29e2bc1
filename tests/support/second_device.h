// SPDX-License-Identifier: MIT
// second_device.h -- the device to which worlds of tests move, and a world for such moves.
#ifndef SECOND_DEVICE_H
#define SECOND_DEVICE_H
#include "support/make_bodies.h"

// Set-up: finds an OpenCL device with equal bits. second_device gets its name, or stays empty if there is none.
int find_second_device(void** state);
extern char second_device[128];

#define NEEDS_SECOND_DEVICE() \
	if (!second_device[0])    \
	skip()

// Opens a pyramid of boxes with a circle above. It is still in motion after 20 steps. alone: with one thread, otherwise
// two.
scree_world* open_pile(const char* device, bool alone);

// Returns the hash of the pile after some steps with one thread.
uint64_t hash_after(int steps);

#endif
