// SPDX-License-Identifier: MIT
// batch.h -- executes a batch in one part: uploads the items, runs the kernel, checks the items, and reads the results.
#ifndef BATCH_H
#define BATCH_H
#include "backend/backend.h"

scree_status batch_whole(Backend* b, const Step* step, const Batch* batch);

#endif
