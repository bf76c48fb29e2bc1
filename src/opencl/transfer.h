// SPDX-License-Identifier: MIT
// transfer.h -- transfers large arrays to and from a GPU, by several threads through pinned memory.
#ifndef TRANSFER_H
#define TRANSFER_H
#include "opencl/opencl_state.h"

#define TRANSFER_BLOCK ((size_t)8 << 20) // bytes of a block of pinned memory

// Returns whether transfer_up and transfer_down are faster than a plain copy of `count` bytes.
bool transfer_wanted(const OpenCl* d, size_t count);

// transfer_up copies bytes to a buffer, in order with the queue; the caller may overwrite them after the call.
// transfer_down copies from a buffer and returns when the copy is complete.
scree_status transfer_up(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count);
scree_status transfer_down(OpenCl* d, cl_mem buffer, size_t offset, void* bytes, size_t count);

// Steps of a transfer, which round trips use too. transfer_open allocates blocks and threads at its first call.
scree_status transfer_open(OpenCl* d);
unsigned char* transfer_block(const OpenCl* d, int block);
// Waits for the last command that uses a block.
scree_status transfer_settle(OpenCl* d, int block);
// Enqueue a transfer between an unused block (transfer_settle) and a buffer. wait: event that precedes it, or null.
scree_status transfer_send(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                           size_t bytes);
scree_status transfer_fetch(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                            size_t bytes);
typedef struct // a copy within host memory; transfer_copy divides each copy among all threads
{
	void* to;
	const void* from;
	size_t bytes;
} Load;
void transfer_copy(OpenCl* d, const Load* loads, int count);

void transfer_close(OpenCl* d);

#endif
