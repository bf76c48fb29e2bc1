// SPDX-License-Identifier: MIT
// readback.h -- reads pools, either at once or while the device continues; see src/backend/backend.h.
#ifndef READBACK_H
#define READBACK_H
#include "opencl/opencl_state.h"

scree_status read_open(OpenCl* d);
void read_close(OpenCl* d);
scree_status opencl_read(Backend* b, PoolId pool, int first, int count, void* items);
scree_status opencl_read_begin(Backend* b, PoolId pool, int first, int count);
scree_status opencl_read_end(Backend* b, void* items);

#endif
