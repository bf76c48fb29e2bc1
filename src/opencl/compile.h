// SPDX-License-Identifier: MIT
// compile.h -- builds an embedded OpenCL program for a device, or takes it from the cache.
#ifndef COMPILE_H
#define COMPILE_H
#include "opencl/cache.h"
#include "opencl/device.h"

#define PROGRAM_OPTIONS 64 // bytes of the options that are given, at most

// Builds text, which cmake/embed.cmake wrote, with options and those that equal bits need. The caller releases
// *program. If the build fails, the messages of the compiler go to the log.
scree_status program_build(cl_context context, const Device* device, const char* options, const char* text,
                           size_t length, cl_program* program);

// Its key in the cache: a digest of all that can change the binary.
Digest program_key(const Device* device, const char* options, const char* text, size_t length);

#endif
