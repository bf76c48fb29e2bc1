// SPDX-License-Identifier: MIT
// batch_transfer.h -- a batch: sends many items to a GPU, runs a kernel over them, fetches the answers, all at once.
#ifndef BATCH_TRANSFER_H
#define BATCH_TRANSFER_H
#include "opencl/opencl_state.h"

scree_status opencl_batch(Backend* b, const Step* step, const Batch* batch);
void batch_close(OpenCl* d);

#endif
