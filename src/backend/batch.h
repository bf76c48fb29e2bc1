// SPDX-License-Identifier: MIT
// batch.h -- a batch: the upload of many items, a kernel over each, and the readback of an answer for each.
#ifndef BATCH_H
#define BATCH_H
#include "backend/backend.h"

scree_status batch_whole(Backend* b, const Step* step, const Batch* batch);

#endif
