// SPDX-License-Identifier: MIT
// external_memory.h -- shares memory with other programs on the device: render rows, queries, rows of batches.
#ifndef EXTERNAL_MEMORY_H
#define EXTERNAL_MEMORY_H
#include "opencl/opencl_state.h"

// Creates the context. It shares memory with OpenGL if `opengl` is not null and the driver supports sharing.
scree_status share_open_context(OpenCl* d, const scree_opengl* opengl);
void shared_close(OpenCl* d);
scree_status opencl_share(Backend* b, SharedUse use, const SharedMemory* memory);
scree_status opencl_render(Backend* b, const Run* run);
scree_status opencl_download(Backend* b, SharedUse use, PoolId pool, int first, int count, size_t offset);
scree_status opencl_upload(Backend* b, SharedUse use, PoolId pool, int first, int count, size_t offset);

#endif
