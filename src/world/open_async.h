// SPDX-License-Identifier: MIT
// open_async.h -- a device opened by a thread of its own, while the world goes on elsewhere.
#ifndef OPENING_H
#define OPENING_H
#include "backend/backend.h"

typedef struct Opening Opening;

// Begins to open a GPU, or the device of this name unless it is null, and to compare its bits with the CPU's. Null when
// there is no memory or no thread to be had.
Opening* opening_begin(const scree_world_def* def, const char* device);

// Whether opening_end would return at once.
bool opening_done(const Opening* opening);

// Waits for the device and releases the opening. *milliseconds is how long it took to open, without
// the comparison. Fails with the sentence set and
// *backend null when there is no device, or none that leaves the same bits.
scree_status opening_end(Opening* opening, Backend** backend, double* milliseconds);

#endif
