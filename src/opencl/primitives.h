// SPDX-License-Identifier: MIT
// primitives.h -- launches sort and scan (primitives.cl).
#ifndef OPENCL_PRIMITIVES_H
#define OPENCL_PRIMITIVES_H
#include "opencl/opencl_state.h"

scree_status primitives_open(OpenCl* d);
void primitives_close(OpenCl* d);
scree_status primitives_bind(OpenCl* d); // sets the buffers that sort and scan use as arguments of their kernels
scree_status primitive_run(OpenCl* d, const Run* run);

#endif
