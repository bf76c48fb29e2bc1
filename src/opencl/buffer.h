// SPDX-License-Identifier: MIT
// buffer.h -- creates scratch buffers, pinned memory and other buffers that are not pools.
#ifndef OPENCL_BUFFER_H
#define OPENCL_BUFFER_H
#include "opencl/opencl_state.h"

// Creates a buffer of zeros. Fails with SCREE_ERROR_OUT_OF_MEMORY if the device has too little memory.
scree_status buffer_create(OpenCl* d, size_t bytes, cl_mem* buffer);

// Grows a scratch buffer to at least `bytes`, and updates Backend.bytes. A buffer that grows is filled with zeros.
scree_status scratch_reserve(OpenCl* d, Scratch* scratch, size_t bytes);
void scratch_release(OpenCl* d, Scratch* scratch);
// Waits for the queue, releases `count` scratch buffers and subtracts their sizes from Backend.bytes.
scree_status scratch_drop(OpenCl* d, Scratch* const* scratch, int count);

scree_status pinned_open(OpenCl* d, size_t bytes, Pinned* pinned);
void pinned_close(OpenCl* d, Pinned* pinned);

// As BackendFunctions.pin and unpin.
scree_status opencl_pin(Backend* b, size_t bytes, void** memory);
void opencl_unpin(Backend* b, void* memory);
// Returns whether the device can transfer a range without a copy, because it is in memory of opencl_pin.
bool is_pinned(const OpenCl* d, const void* at, size_t bytes);

#endif
