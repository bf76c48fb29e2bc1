// SPDX-License-Identifier: MIT
// batch_transfer.h -- executes a batch on a GPU in parts that overlap.
#ifndef BATCH_TRANSFER_H
#define BATCH_TRANSFER_H
#include "opencl/opencl_state.h"

scree_status opencl_batch(Backend* b, const Step* step, const Batch* batch);
void batch_close(OpenCl* d);

#endif
