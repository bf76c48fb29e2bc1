// SPDX-License-Identifier: MIT
// relay.h -- launches the solve as one relay (relay.cl).
#ifndef OPENCL_RELAY_H
#define OPENCL_RELAY_H
#include "opencl/opencl_state.h"

// Makes the kernels, gives them the buffer of a kind, tests whether the device can run them.
scree_status relay_create(OpenCl* d);
scree_status relay_bind(OpenCl* d, Per per);
scree_status relay_open(OpenCl* d);
void relay_close(OpenCl* d);
// Reserves the memory of a solve.
scree_status relay_reserve(OpenCl* d, const Solve* solve);
scree_status mailboxes_reserve(OpenCl* d, const Solve* solve); // for tiles, whose border is a relay
scree_status relay_run(OpenCl* d, const Solve* solve);
// Whether the kernels of plain worlds (registers.cl) suffice for the step.
bool solve_plain(const OpenCl* d);

#endif
