// SPDX-License-Identifier: MIT
// program.h -- builds an embedded OpenCL program for a device, or takes it from the cache.
#ifndef OPENCL_PROGRAM_H
#define OPENCL_PROGRAM_H
#include "opencl/device.h"

// options are added to those that equal bits need. text is what cmake/embed.cmake wrote. The caller releases *program. When it does not build, the compiler's messages
// go to the log.
scree_status program_build(cl_context context, const Device* device, const char* options, const char* text,
                           size_t length, cl_program* program);

#endif
