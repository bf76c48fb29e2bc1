// SPDX-License-Identifier: MIT
// batch.h -- many items to a device, a stage over each, and an answer for each back.
#ifndef BATCH_H
#define BATCH_H
#include "backend/backend.h"

// In turns: all items, the stage, all answers.
scree_status batch_whole(Backend* b, const Step* step, const Batch* batch);

#endif
