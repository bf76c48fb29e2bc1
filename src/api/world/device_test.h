// SPDX-License-Identifier: MIT
// device_test.h -- tests a device by small worlds, which it steps as the CPU does.
#ifndef DEVICE_TEST_H
#define DEVICE_TEST_H
#include "backend/backend.h"

// A build without OpenCL has no device to test, and leaves out the worlds.
#ifdef SCREE_NO_OPENCL
#define TEST_WORLDS NULL
#else
#define TEST_WORLDS test_worlds
#endif

// Is a TestWorlds: compares each sample world in each form of execution that the device uses.
scree_status test_worlds(Backend* b, WorldsTest* test);

#endif
