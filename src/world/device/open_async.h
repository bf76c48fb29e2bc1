// SPDX-License-Identifier: MIT
// open_async.h -- opens a device on a thread of its own.
#ifndef OPEN_ASYNC_H
#define OPEN_ASYNC_H
#include "world/auto_state.h"

// Begins to open a GPU, or the device of this name unless it is null. compare is called on the open device, on the same
// thread; when it fails, the device is closed. Null when there is no memory or no thread.
AsyncOpen* async_open_begin(const scree_world_def* def, const char* device, CompareDevice* compare);

// Whether async_open_end would return at once.
bool async_open_done(const AsyncOpen* opening);

// Waits for the device and releases the opening. *milliseconds is the time that it took to open, without the comparison.
// Fails with the sentence set and *backend null when no device was opened, or compare failed.
scree_status async_open_end(AsyncOpen* opening, Backend** backend, double* milliseconds);

#endif
