// SPDX-License-Identifier: MIT
// recordings.h -- makes and repeats recordings in memory for tests.
#ifndef RECORDINGS_H
#define RECORDINGS_H
#include "platform/processor.h"
#include "support/snapshots.h"

// Begins a recording in memory with a hash in each step.
static inline void record_hashes(scree_world* world)
{
	scree_record_def def = scree_record_def_default();
	def.hash_interval = 1;
	OK(scree_world_record(world, &def));
}

// Copies the recording of a world. The caller frees its bytes.
static inline Saved recording_of(const scree_world* world)
{
	const void* bytes;
	size_t size;
	OK(scree_world_get_recording(world, &bytes, &size));
	return copy_of(bytes, size);
}

// Returns a definition. lanes: 0 is taken if this build or processor lacks that number.
static inline scree_world_def def_on(const char* device, int threads, int lanes)
{
	scree_world_def def = scree_world_def_default();
	def.device = device;
	def.threads = threads;
	def.lanes = processor_has_lanes(lanes) ? lanes : 0;
	return def;
}

static inline scree_replay_info info_of(const scree_replay* replay)
{
	scree_replay_info info;
	OK(scree_replay_get_info(replay, &info));
	return info;
}

// Repeats all steps of a replay. Returns the first failure.
static inline scree_status repeat_steps(scree_replay* replay, scree_world* world)
{
	scree_status status;
	bool stepped;
	do
		status = scree_replay_step(replay, world, &stepped);
	while (status == SCREE_OK && stepped);
	return status;
}

// Repeats a recording on a device. Returns the hash at its end.
static inline uint64_t repeat_on(Saved saved, scree_world_def def)
{
	scree_replay* replay;
	scree_world* world;
	uint64_t hash;
	OK(scree_replay_open(saved.bytes, saved.size, &replay));
	OK(scree_replay_create_world(replay, &def, &world));
	OK(repeat_steps(replay, world));
	scree_replay_info info = info_of(replay);
	assert_true(info.step == info.steps);
	OK(scree_world_get_hash(world, &hash));
	scree_world_destroy(world);
	scree_replay_close(replay);
	return hash;
}

#endif
