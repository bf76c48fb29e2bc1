// SPDX-License-Identifier: MIT
// copy.h -- copies within the device, to measure the bandwidth of its memory; src/backend/backend.h.
#ifndef OPENCL_COPY_H
#define OPENCL_COPY_H
#include "opencl/state.h"

scree_status opencl_copy_reserve(Backend* b, size_t bytes);
void opencl_copy_release(Backend* b);
scree_status opencl_copy(Backend* b, int times);

#endif
