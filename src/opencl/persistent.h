// SPDX-License-Identifier: MIT
// persistent.h -- executes many runs in one launch (persistent.cl), on devices that support it.
#ifndef OPENCL_PERSISTENT_H
#define OPENCL_PERSISTENT_H
#include "opencl/opencl_state.h"

// Tests whether the device can run the persistent kernel; if not, sets persistent.groups to 0.
scree_status persistent_open(OpenCl* d);
void persistent_close(OpenCl* d);
// Returns the number of runs at the start of a list that are faster in one launch than in several; 0 or at least 2.
int persistent_length(const OpenCl* d, const Run* runs, int count);
scree_status persistent_run(OpenCl* d, const Run* runs, int count);

#endif
