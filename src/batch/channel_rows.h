// SPDX-License-Identifier: MIT
// channel_rows.h -- allocates the rows of a list of channels, checks those of inputs, and converts rows to metres and back.
#ifndef CHANNEL_ROWS_H
#define CHANNEL_ROWS_H
#include "batch/channel_set.h"

// Sets the memory of a list to zeros. pins: device that transfers the memory without a copy, if it can; null: none.
scree_status channel_rows_open(ChannelSet* set, const char* function, int worlds, Backend* pins);
// Releases memory of the batch; that of the user stays.
void channel_rows_close(ChannelSet* set);

// Checks rows of inputs. first: number of the world of the first row. mask: per world, 0 for rows to skip; null: none.
scree_status channels_check(const ChannelSet* set, const char* function, const float* rows, int first, int count,
                            const uint8_t* mask);

// Checks a row of the inputs of a world. function: for the message.
scree_status channels_check_row(const ChannelSet* set, const char* function, const float* row, int world);

// Copies a row of inputs, with normalized rotations and in metres; or a row of outputs, in units of length.
void channels_put(const ChannelSet* set, float* to, const float* from);
void channels_get(const ChannelSet* set, float* to, const float* from);

#endif
