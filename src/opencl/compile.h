// SPDX-License-Identifier: MIT
// compile.h -- builds an embedded OpenCL program for a device, or takes it from the cache.
#ifndef COMPILE_H
#define COMPILE_H
#include "opencl/cache.h"
#include "opencl/context_failure.h"
#include "opencl/device.h"

#define PROGRAM_OPTIONS 128 // maximum size of the argument `options` in bytes, with the final zero

// Builds the program `text`, which cmake/embed.cmake generated, with the given options, and with the options that equal
// bits require. The caller releases *program. If the build fails, the compiler's messages are logged. failure: that of
// the context.
scree_status program_build(ContextFailure* failure, cl_context context, const Device* device, const char* options,
                           const char* text, size_t length, cl_program* program);

// Returns the key of a program in the cache: a digest of everything on which the binary depends.
Digest program_key(const Device* device, const char* options, const char* text, size_t length);

#endif
