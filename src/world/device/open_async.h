// SPDX-License-Identifier: MIT
// open_async.h -- opens a device on a separate thread.
#ifndef OPEN_ASYNC_H
#define OPEN_ASYNC_H
#include "world/auto_state.h"

// Begins to open a device on a new thread. device: name of the device, or null for any GPU. A device without a
// verdict is tested there, with `test`. Returns null if there is no memory or no thread.
AsyncOpen* async_open_begin(const scree_world_def* def, const char* device, TestWorlds* test);
bool async_open_done(const AsyncOpen* opening);

// Waits for the thread, and releases `opening`. Sets *backend to the open device, and *milliseconds to the time to open
// it, without that of the test. On failure *backend is null.
scree_status async_open_end(AsyncOpen* opening, Backend** backend, double* milliseconds);

#endif
