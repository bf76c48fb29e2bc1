// SPDX-License-Identifier: MIT
// gate.h -- opens devices whose bits are those of the CPU, by tests and not by the features that a driver reports.
#ifndef GATE_H
#define GATE_H
#include "opencl/device.h"

// Opens a device without any test.
typedef scree_status OpenDevice(const BackendOptions* options, const Device* device, Backend** backend);

// Chooses a device and opens it. If there is no verdict on it, tests it first, and stores the verdict. A device that
// failed is passed over, unless the options allow unequal bits. Without options->test no device is tested.
scree_status gate_open(const BackendOptions* options, OpenDevice* open, Backend** backend);

// Implements opencl_test.
scree_status gate_test(const BackendOptions* options, OpenDevice* open);

#endif
