// SPDX-License-Identifier: MIT
// context.h -- opens OpenCL contexts and builds programs in them; the worlds of a process share contexts and programs.
#ifndef OPENCL_CONTEXT_H
#define OPENCL_CONTEXT_H
#include "opencl/opencl_state.h"

// Sets the context and the program of a device. opengl: null, or an OpenGL context to share memory with; with it,
// context and program are not shared with other worlds.
scree_status context_open(OpenCl* d, const char* options, const scree_opengl* opengl);

// Releases the context and the program, unless other worlds use them or they are kept.
void context_close(OpenCl* d);

#endif
