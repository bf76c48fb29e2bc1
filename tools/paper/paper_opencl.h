// SPDX-License-Identifier: MIT
// paper_opencl.h -- the first three stages through OpenCL: each step copies the pools to the device and back.
#ifndef PAPER_OPENCL_H
#define PAPER_OPENCL_H
#include "tools/paper/paper_state.h"

// Opens a device; part: of its name, null for any. The caller closes it also on failure.
scree_status paper_opencl_open(Paper* paper, const char* part, bool allow_unequal_bits);
void paper_opencl_close(Paper* paper);

// Runs the first three stages. The contacts are in the pool of the host, in any order.
scree_status paper_opencl_run(Paper* paper);

#endif
