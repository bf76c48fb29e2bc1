// SPDX-License-Identifier: MIT
// relay.h -- launches a whole solve as one kernel, a relay (relay.cl).
#ifndef OPENCL_RELAY_H
#define OPENCL_RELAY_H
#include "opencl/opencl_state.h"

// relay_bind sets the buffer of a kind as an argument of each kernel; relay_open tests whether the device can run them.
scree_status relay_create(OpenCl* d);
scree_status relay_bind(OpenCl* d, Per per);
scree_status relay_open(OpenCl* d);
void relay_close(OpenCl* d);
scree_status relay_reserve(OpenCl* d, const Solve* solve);
scree_status mailboxes_reserve(OpenCl* d, const Solve* solve); // called for tiles too: a relay solves their border
scree_status relay_run(OpenCl* d, const Solve* solve);
// Returns whether there are no springs, couplings and joints on paths (STEP_HINGES).
bool solve_hinges(const OpenCl* d);
// Returns whether there are no joints, heavy bodies, radii, restitution, rolling resistance and tangent speeds
// (STEP_PLAIN).
bool solve_plain(const OpenCl* d);

#endif
