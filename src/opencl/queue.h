// SPDX-License-Identifier: MIT
// queue.h -- enqueues launches and uploads, waits for the queue, and measures launches.
#ifndef OPENCL_QUEUE_H
#define OPENCL_QUEUE_H
#include "opencl/opencl_state.h"

// Bytes of Staging.pinned. If uploads in progress exceed it, the host waits. Replacing 4,000 bodies uploads 1 MB.
#define STAGING_BYTES ((size_t)8 << 20)

scree_status timing_open(OpenCl* d);

// Returns the number of work-groups of size `group` for `items` items, at least 1.
static inline size_t groups_of(int items, size_t group) { return items > 0 ? ((size_t)items + group - 1) / group : 1; }

// Launches a kernel. group: work-items per work-group; items: number of work-items, a multiple of `group`.
scree_status launch(OpenCl* d, cl_kernel kernel, size_t items, size_t group);

// Copies `count` bytes to a buffer, in order with the launches. The caller may overwrite `bytes` after the call.
scree_status upload(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count);

// Returns once a command of a flushed queue has ended, or fails after OpenCl.wait_limit. Releases the event and sets it
// to null.
scree_status event_wait(OpenCl* d, cl_event* event);

// Flushes a queue, then calls event_wait.
scree_status queue_wait(OpenCl* d, cl_command_queue queue, cl_event* event);

// Returns once all commands of a queue have ended, or fails after OpenCl.wait_limit.
scree_status queue_finish(OpenCl* d, cl_command_queue queue);

// Waits for the queue of the device, and adds up the times of the launches.
scree_status finish(OpenCl* d);

// Waits as finish does, for a device that is being closed; logs an error.
void finish_to_close(OpenCl* d);

scree_status opencl_timings(Backend* b, double milliseconds[STAGE_COUNT]);

#endif
