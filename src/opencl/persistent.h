// SPDX-License-Identifier: MIT
// persistent.h -- executes many runs in one launch (persistent.cl), on devices that support it.
#ifndef OPENCL_PERSISTENT_H
#define OPENCL_PERSISTENT_H
#include "opencl/opencl_state.h"

// Tests whether the device can run the persistent kernel; if not, persistent.groups is 0.
scree_status persistent_open(OpenCl* d);
void persistent_close(OpenCl* d);
// Returns the number of runs, from the first on, that are faster as one launch; 0 if separate launches are faster.
int persistent_length(const OpenCl* d, const Run* runs, int count);
scree_status persistent_run(OpenCl* d, const Run* runs, int count);

#endif
