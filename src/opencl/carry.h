// SPDX-License-Identifier: MIT
// carry.h -- large arrays to and from a GPU: by several threads through pinned memory.
#ifndef OPENCL_CARRY_H
#define OPENCL_CARRY_H
#include "opencl/state.h"

// Whether a copy of so many bytes is worth it.
bool carry_wanted(const OpenCl* d, size_t count);

// Copies to a buffer, in order with the queue; returns when the bytes may change. And from a buffer; waits.
scree_status carry_up(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count);
scree_status carry_down(OpenCl* d, cl_mem buffer, size_t offset, void* bytes, size_t count);
void carry_close(OpenCl* d);

#endif
