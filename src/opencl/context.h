// SPDX-License-Identifier: MIT
// context.h -- OpenCL contexts and the programs built in them, which the worlds of a process share.
#ifndef OPENCL_CONTEXT_H
#define OPENCL_CONTEXT_H
#include "opencl/opencl_state.h"

// Gives a device its context and its program. options are those of the compiler. opengl is null, or a context that it shares memory
// with: then it has a context and a program of its own.
scree_status context_open(OpenCl* d, const char* options, const scree_opengl* opengl);

// Releases both, if no other world has them.
void context_close(OpenCl* d);

#endif
