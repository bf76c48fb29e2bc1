// SPDX-License-Identifier: MIT
// device_name.h -- chooses an OpenCL device by a part of its name, and its number among devices of one name.
#ifndef DEVICE_NAME_H
#define DEVICE_NAME_H
#include "opencl/device.h"

// Chooses a device whose name or platform name contains options->device (case ignored). "#2" at its end chooses among devices
// with number 2. Prefers devices that the options allow, then a whole name, then GPUs, then devices with equal bits. A device
// without a verdict counts as one with equal bits; opencl_open tests it. Fails with SCREE_ERROR_NO_DEVICE if no device is found
// or the best is not allowed.
scree_status device_choose(const BackendOptions* options, Device* device);

#endif
