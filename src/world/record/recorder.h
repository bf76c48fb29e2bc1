// SPDX-License-Identifier: MIT
// recorder.h -- records the calls that change a world, in memory or into a file.
//
// A world has a list of recorders: that of the user (scree_world_record), and those of programs that also keep the past. A
// recorder that fails, for lack of memory or because a file cannot be written, logs a warning and records no further call; no
// call of the user fails for that.
#ifndef RECORDER_H
#define RECORDER_H
#include "world/record/record_log.h"
#include <stdio.h>

typedef struct Recorder
{
	struct Recorder* next; // next recorder of the world
	ChunkWriter written;   // whole recording in memory; for a file: records that are not yet written
	ChunkWriter payload;   // bytes of the record in progress
	uint64_t chain;        // digest of all records
	FILE* file;            // null: the recording is in memory
	char* path;            // path of the file, or null
	int hash_interval;     // steps from one hash to the next; 0: no hashes but the last
	uint64_t saves;        // bit k: the recording contains a scree_world_save of number k
	int64_t steps;         // steps that were recorded
	scree_status status;   // first failure
	char sentence[512];    // message of that failure
	bool begun, ended;
} Recorder;

// Makes a recorder with the snapshot of a world, and adds it to the list of the world. path: null for memory.
scree_status recorder_open(scree_world* world, const char* function, const char* path, int hash_interval,
                           Recorder** made);
// Ends a recording, and removes it from the list of the world. hash: records the world hash as the last record. Returns the first
// failure of the recording.
scree_status recorder_end(scree_world* world, Recorder* recorder, const char* function, bool hash);
// Releases a recorder that has ended.
void recorder_free(Recorder* recorder);
// Ends and releases all recorders, before a world is destroyed.
void recorders_close(scree_world* world);

// Before a recorded call: counts calls in progress.
void recorders_enter(scree_world* world);
// After a recorded call: records it, and returns `status`. values: the address of each argument.
scree_status recorders_leave(scree_world* world, RecordedCallId call, const void* const* values, scree_status status);
// Before a step: records it, and writes all records to the files, so that a recording contains a step that crashes.
void recorders_enter_step(scree_world* world, RecordedCallId call, const void* const* values);
// After a step: records a failure, or a hash if one is due. Returns `status`.
scree_status recorders_leave_step(scree_world* world, RecordedCallId call, const void* const* values,
                                  scree_status status);

#endif
