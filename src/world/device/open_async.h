// SPDX-License-Identifier: MIT
// open_async.h -- opens a device on a separate thread.
#ifndef OPEN_ASYNC_H
#define OPEN_ASYNC_H
#include "world/auto_state.h"

// Begins to open a GPU, or the device with the given name unless it is null. The thread then calls compare for the open
// device, and closes the device if compare fails. Returns null if there is no memory or no thread.
AsyncOpen* async_open_begin(const scree_world_def* def, const char* device, CompareDevice* compare);
bool async_open_done(const AsyncOpen* opening);

// Waits for the device and releases the opening. *milliseconds is the time to open the device, without the comparison.
// If no device was opened, or compare failed, fails with the error message set and *backend null.
scree_status async_open_end(AsyncOpen* opening, Backend** backend, double* milliseconds);

#endif
