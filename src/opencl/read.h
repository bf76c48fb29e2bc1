// SPDX-License-Identifier: MIT
// read.h -- reads pools, and waits for the read or lets the device continue; src/backend/backend.h.
#ifndef OPENCL_READ_H
#define OPENCL_READ_H
#include "opencl/state.h"

scree_status read_open(OpenCl* d);
void read_close(OpenCl* d);
scree_status opencl_read(Backend* b, PoolId pool, int first, int count, void* items);
scree_status opencl_read_begin(Backend* b, PoolId pool, int first, int count);
scree_status opencl_read_end(Backend* b, void* items);

#endif
