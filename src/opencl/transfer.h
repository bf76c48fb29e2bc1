// SPDX-License-Identifier: MIT
// transfer.h -- large arrays to and from a GPU: by several threads through pinned memory.
#ifndef TRANSFER_H
#define TRANSFER_H
#include "opencl/opencl_state.h"

// bytes of a block of pinned memory
#define TRANSFER_BLOCK ((size_t)8 << 20)

// Whether a copy of so many bytes is worth it.
bool transfer_wanted(const OpenCl* d, size_t count);

// Copies to a buffer, in order with the queue; returns when the bytes may change. And from a buffer; waits.
scree_status transfer_up(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count);
scree_status transfer_down(OpenCl* d, cl_mem buffer, size_t offset, void* bytes, size_t count);

// The parts of such copies. Allocates the blocks and starts the threads; later calls do nothing.
scree_status transfer_open(OpenCl* d);
unsigned char* transfer_block(const OpenCl* d, int block);
// Waits until the device is done with a block: with the command that got its event.
scree_status transfer_settle(OpenCl* d, int block);
// Transfers between a block and a buffer, after the event wait unless that is null. The block must be settled.
scree_status transfer_send(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                           size_t bytes);
scree_status transfer_fetch(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                            size_t bytes);
// Copies in the host's memory, by all threads.
typedef struct
{
	void* to;
	const void* from;
	size_t bytes;
} Load;
void transfer_copy(OpenCl* d, const Load* loads, int count);

void transfer_close(OpenCl* d);

#endif
