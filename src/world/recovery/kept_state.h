// SPDX-License-Identifier: MIT
// kept_state.h -- keeps a state of a world in host memory, and the calls since, so that the world can go on without its device.
//
// A kept state is a save of the library (world/save/saves.h) of which host memory has a copy. So it takes the time of a save and of
// a copy of its bytes from the device. The saves of the user are copied too, each once.
#ifndef KEPT_STATE_H
#define KEPT_STATE_H
#include "world/record/call_list.h"
#include "world/world.h"

#define RECORD_MOVED 0 // number of a record beside those of calls: a call of scree_world_get_moved_bodies

typedef struct
{
	int save;             // number of the save, at least SCREE_SAVES; 0: no state is kept
	int64_t step;         // Pipeline.steps of the state
	uint8_t* copy;        // copy of the pool `saved`, as far as saves have been copied
	int items;            // number of items of `copy`
	ChunkWriter calls;    // records of the calls since, which a replay of the library reads (record_log.h)
	ChunkWriter payload;  // bytes of the record in progress
	uint64_t chain;       // digest of the records
	int count;            // number of records
	uint64_t saves, read; // bit k: the user has made save k, or loaded an older save k, since the state was kept
} KeptState;

// Keeps the present state in place of the last one. On failure the last one stays.
scree_status kept_state_take(scree_world* world, const char* function, KeptState* kept);

// Appends a record of a call, or of RECORD_MOVED with `values` null. Returns false if there is no memory; the calls are then
// not complete, so another state must be kept.
bool kept_state_add(KeptState* kept, uint64_t number, const void* const* values);

// Brings a new world on the CPU into the kept state. It takes over the saves of `world`, whose device has failed.
scree_status kept_state_bring(const KeptState* kept, const char* function, scree_world* made);

// Gives up the kept state and its memory.
void kept_state_close(scree_world* world, KeptState* kept);

#endif
