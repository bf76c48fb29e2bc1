// SPDX-License-Identifier: MIT
// open_async.h -- a device opened by a thread of its own, while the world goes on elsewhere.
#ifndef OPENING_H
#define OPENING_H
#include "backend/backend.h"

typedef struct AsyncOpen AsyncOpen;

// Begins to open a GPU, or the device of this name unless it is null, and to compare its bits with the CPU's. Null when
// there is no memory or no thread to be had.
AsyncOpen* async_open_begin(const scree_world_def* def, const char* device);

// Whether async_open_end would return at once.
bool async_open_done(const AsyncOpen* opening);

// Waits for the device and releases the opening. *milliseconds is how long it took to open, without
// the comparison. Fails with the sentence set and
// *backend null when there is no device, or none that leaves the same bits.
scree_status async_open_end(AsyncOpen* opening, Backend** backend, double* milliseconds);

#endif
