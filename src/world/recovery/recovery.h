// SPDX-License-Identifier: MIT
// recovery.h -- lets a world go on on the CPU when its device fails, if scree_world_def.recovery_interval is set.
//
// While the world is on a device, a state is kept every recovery_interval steps, and each call since. When a call fails with the
// device, the caller repeats it after world_recovers.
#ifndef RECOVERY_H
#define RECOVERY_H
#include "world/record/call_list.h"
#include "world/recovery/kept_state.h"

typedef struct Recovery
{
	KeptState kept;
	int waited;  // number of steps since a state was last kept
	size_t most; // bytes of calls with which the next state is kept
	bool due;    // a state must be kept after the present call
} Recovery;

// Begins recovery in a new world, if its definition has an interval.
scree_status recovery_begin(scree_world* world, const char* function);
void recovery_close(scree_world* world);

// Keeps a state if none is kept, before a move to a device, of which the first call may fail. Fails only if the device does.
scree_status recovery_prepare(scree_world* world, const char* function);

// Returns whether a call that failed must be repeated: its device has failed, and the world is now on the CPU, in the state before
// the call. Otherwise the call returns its status.
bool world_recovers(scree_world* world, const char* function, scree_status status);

// After a recorded call with its status: adds it to the calls since the kept state, or keeps a state.
void recovery_note(scree_world* world, RecordedCallId call, const void* const* values, scree_status status);
// After another call. call: its name without "scree_". noted: it was scree_world_get_moved_bodies, which begins a new list.
void recovery_read(scree_world* world, const char* call, bool noted);

#endif
