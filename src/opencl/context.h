// SPDX-License-Identifier: MIT
// context.h -- OpenCL contexts and the programs built in them, shared by the worlds of a process.
#ifndef OPENCL_CONTEXT_H
#define OPENCL_CONTEXT_H
#include "opencl/opencl_state.h"

// Gives a device its context and program. opengl: null, or a context to share memory with; then both are its own.
scree_status context_open(OpenCl* d, const char* options, const scree_opengl* opengl);

// Releases the context and the program, unless another world uses them.
void context_close(OpenCl* d);

#endif
