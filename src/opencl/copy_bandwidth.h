// SPDX-License-Identifier: MIT
// copy_bandwidth.h -- copies blocks within device memory, to measure bandwidth; see src/backend/backend.h.
#ifndef COPY_BANDWIDTH_H
#define COPY_BANDWIDTH_H
#include "opencl/opencl_state.h"

scree_status opencl_copy_reserve(Backend* b, size_t bytes);
void opencl_copy_release(Backend* b);
scree_status opencl_copy(Backend* b, int times);

#endif
