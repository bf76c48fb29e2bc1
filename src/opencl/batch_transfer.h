// SPDX-License-Identifier: MIT
// batch_transfer.h -- many items to a GPU, a stage over each, and the answers back: three things at a time.
#ifndef BATCH_TRANSFER_H
#define BATCH_TRANSFER_H
#include "opencl/opencl_state.h"

scree_status opencl_batch(Backend* b, const Step* step, const Batch* batch);
void batch_close(OpenCl* d);

#endif
