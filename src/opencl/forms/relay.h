// SPDX-License-Identifier: MIT
// relay.h -- launches a whole solve as one kernel, a relay (relay.cl).
#ifndef OPENCL_RELAY_H
#define OPENCL_RELAY_H
#include "opencl/opencl_state.h"

// relay_bind sets a buffer as an argument of the kernels; relay_open tests whether the device can run them.
scree_status relay_create(OpenCl* d);
scree_status relay_bind(OpenCl* d, Per per);
scree_status relay_open(OpenCl* d);
void relay_close(OpenCl* d);
scree_status relay_reserve(OpenCl* d, const Solve* solve);
scree_status mailboxes_reserve(OpenCl* d, const Solve* solve); // tiles call it too: their border is a relay
scree_status relay_run(OpenCl* d, const Solve* solve);
// Returns whether the kernels for plain worlds (STEP_PLAIN) are sufficient for the step.
bool solve_plain(const OpenCl* d);

#endif
