// SPDX-License-Identifier: MIT
// channel_rows.h -- allocates memory for the rows of a list of channels.
#ifndef CHANNEL_ROWS_H
#define CHANNEL_ROWS_H
#include "batch/channel_set.h"

// Sets the memory of a list to zeros. pins: device that transfers the memory without a copy, if it can; null: none.
scree_status channel_rows_open(ChannelSet* set, const char* function, int worlds, Backend* pins);
// Releases memory of the batch; that of the user stays.
void channel_rows_close(ChannelSet* set);

#endif
