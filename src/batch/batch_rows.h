// SPDX-License-Identifier: MIT
// batch_rows.h -- allocates memory for the rows of a list of channels.
#ifndef BATCH_ROWS_H
#define BATCH_ROWS_H
#include "batch/batch.h"

// Allocates memory for the rows of a list of channels; on a GPU, memory that the device transfers without a copy.
scree_status batch_rows_open(scree_batch* batch, const char* function, ChannelSet* set);
void batch_rows_close(scree_batch* batch, ChannelSet* set);

#endif
