// SPDX-License-Identifier: MIT
// context.h -- opens OpenCL contexts and builds programs in them; the worlds of a process share contexts and programs.
#ifndef OPENCL_CONTEXT_H
#define OPENCL_CONTEXT_H
#include "opencl/opencl_state.h"

// Sets d->context and d->program. If `opengl` is not null, only this world uses the context, which shares memory with
// OpenGL.
scree_status context_open(OpenCl* d, const char* options, const scree_opengl* opengl);

// Releases context and program, unless other worlds use them or they are kept (context.c).
void context_close(OpenCl* d);

#endif
