// SPDX-License-Identifier: MIT
// context.h -- OpenCL contexts and the programs built in them, shared by the worlds of a process.
#ifndef OPENCL_CONTEXT_H
#define OPENCL_CONTEXT_H
#include "opencl/opencl_state.h"

// Gives a device its context and its program. options are compiler options. opengl is null, or an OpenGL context to
// share memory with; then the device gets a context and a program of its own.
scree_status context_open(OpenCl* d, const char* options, const scree_opengl* opengl);

// Releases the context and the program, unless another world uses them.
void context_close(OpenCl* d);

#endif
