// SPDX-License-Identifier: MIT
// readback.h -- reads pools, either at once or while the device continues; see src/backend/backend.h.
#ifndef READBACK_H
#define READBACK_H
#include "opencl/opencl_state.h"

scree_status read_open(OpenCl* d);
void read_close(OpenCl* d);

// Returns the first place of the border of the tiles, and one past its last place, in pinned memory.
cl_int* read_edges(const OpenCl* d);
#define EDGES_BYTES (2 * sizeof(cl_int))

// Reads a buffer in order with the launches, and returns after the read. Goes through pinned memory, because a device
// that failed may still write to the destination.
scree_status read_now(OpenCl* d, cl_mem buffer, size_t offset, size_t bytes, void* to);

scree_status opencl_read(Backend* b, PoolId pool, int first, int count, void* items);
scree_status opencl_read_begin(Backend* b, PoolId pool, int first, int count);
scree_status opencl_read_end(Backend* b, void* items);

#endif
