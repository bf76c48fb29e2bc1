// SPDX-License-Identifier: MIT
// open_async.h -- opens a device on a separate thread, and compares its bits with those of the CPU.
#ifndef OPEN_ASYNC_H
#define OPEN_ASYNC_H
#include "world/auto_state.h"

// Begins to open a device on a new thread. device: name of the device, or null for any GPU. The thread then calls
// `compare`, and closes the device again if the comparison fails. Returns null if there is no memory or no thread.
AsyncOpen* async_open_begin(const scree_world_def* def, const char* device, CompareDevice* compare);
bool async_open_done(const AsyncOpen* opening);

// Waits for the thread, and releases `opening`. Sets *backend to the open device, and *milliseconds to the time to open
// it, without that of `compare`. If one of the two failed, sets *backend to null and fails with its message.
scree_status async_open_end(AsyncOpen* opening, Backend** backend, double* milliseconds);

#endif
