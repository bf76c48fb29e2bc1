// SPDX-License-Identifier: MIT
// share.h -- memory that OpenGL draws from, which the kernel of the stage show writes.
#ifndef OPENCL_SHARE_H
#define OPENCL_SHARE_H
#include "opencl/state.h"

// Creates the context of a device. It is shared with OpenGL if opengl is not null and the driver supports it.
scree_status context_open(OpenCl* d, const scree_opengl* opengl);
void shared_close(OpenCl* d);
scree_status opencl_share(Backend* b, const SharedMemory* memory);
scree_status opencl_show(Backend* b, const Run* run);

#endif
