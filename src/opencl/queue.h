// SPDX-License-Identifier: MIT
// queue.h -- the command queue: launches, uploads, waits and their times.
#ifndef OPENCL_QUEUE_H
#define OPENCL_QUEUE_H
#include "opencl/opencl_state.h"

// bytes of Staging.pinned. A step that replaces 4,000 bodies uploads 1 MB. If uploads do not fit, the host waits for
// the queue.
#define STAGING_BYTES ((size_t)8 << 20)

// Allocates the laps.
scree_status timing_open(OpenCl* d);

// work-groups for so many items, at least one
static inline size_t groups_of(int items, size_t group) { return items > 0 ? ((size_t)items + group - 1) / group : 1; }

// Launches a kernel over so many work-items, a multiple of group.
scree_status launch(OpenCl* d, cl_kernel kernel, size_t items, size_t group);

// Copies to a buffer, in order with the launches. The caller may reuse bytes at once.
scree_status upload(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count);

// Waits for the queue and adds up the laps.
scree_status finish(OpenCl* d);

scree_status opencl_timings(Backend* b, double milliseconds[STAGE_COUNT]);

#endif
