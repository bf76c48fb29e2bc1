// SPDX-License-Identifier: MIT
// paper_opencl.h -- executes the first three stages on OpenCL. Each step copies the pools to the device and back.
#ifndef PAPER_OPENCL_H
#define PAPER_OPENCL_H
#include "tools/paper/paper_state.h"

// Opens a device whose name contains the text `part`; null: any device. The caller closes the device, also after a
// failure.
scree_status paper_opencl_open(Paper* paper, const char* part, bool allow_unequal_bits);
void paper_opencl_close(Paper* paper);

// Executes the first three stages. Afterwards the contact pool of the host has the contacts, in no order.
scree_status paper_opencl_run(Paper* paper);

#endif
