// SPDX-License-Identifier: MIT
// queue.h -- the command queue: launches, uploads, waiting for the queue, and times of launches.
#ifndef OPENCL_QUEUE_H
#define OPENCL_QUEUE_H
#include "opencl/opencl_state.h"

// Bytes of Staging.pinned; if uploads exceed it, the host waits. A step that replaces 4,000 bodies uploads 1 MB.
#define STAGING_BYTES ((size_t)8 << 20)

scree_status timing_open(OpenCl* d);

// Returns the number of work-groups for the given items, at least one.
static inline size_t groups_of(int items, size_t group) { return items > 0 ? ((size_t)items + group - 1) / group : 1; }

// Launches a kernel over the given work-items, a multiple of group.
scree_status launch(OpenCl* d, cl_kernel kernel, size_t items, size_t group);

// Copies bytes to a buffer, in order with the launches. The caller may reuse bytes at once.
scree_status upload(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count);

// Waits for the queue and adds up the times of launches.
scree_status finish(OpenCl* d);

scree_status opencl_timings(Backend* b, double milliseconds[STAGE_COUNT]);

#endif
