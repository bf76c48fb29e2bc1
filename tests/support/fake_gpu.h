// SPDX-License-Identifier: MIT
// fake_gpu.h -- turns the CPU of a world into a device that a test lets fail.
#ifndef FAKE_GPU_H
#define FAKE_GPU_H
#include "support/make_bodies.h"

// Opens a world on such a device, with two threads.
scree_world* open_on_fake_gpu(int recovery_interval);

// Makes such a device of the CPU of a world.
void become_fake_gpu(scree_world* world);

// Lets all calls of the device fail from now on. The device is that of the last world that became one.
void fake_gpu_falls(void);

#endif
