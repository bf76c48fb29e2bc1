// SPDX-License-Identifier: MIT
// recorded.c -- records the calls of a program on the reference, and repeats the recording on the other device.
#include "backend/arithmetic.h"
#include "platform/error.h"
#include "programs/run_call.h"
#include <stdlib.h>

void recorded_begin(Pair* pair)
{
	if (!pair->records)
		return;
	scree_record_def def = scree_record_def_default();
	def.hash_interval = 1;
	if (scree_world_record(pair->worlds[0], &def) != SCREE_OK)
		abort();
}

static void write_file(const char* path, const void* bytes, size_t size)
{
	FILE* file = fopen(path, "wb");
	if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
		fprintf(stderr, "programs: %s cannot be written\n", path);
}

// Repeats a recording, whose hash at the end must be that of the reference.
static scree_status repeat(Pair* pair, const void* bytes, size_t size, uint64_t expected)
{
	scree_replay* replay;
	scree_status status = scree_replay_open(bytes, size, &replay);
	if (status != SCREE_OK)
		return status;
	arithmetic_setting.flush = pair->places[1].flush;
	if (!pair->repeated)
		status = run_world(&pair->places[1], &pair->made, &pair->repeated);
	if (status == SCREE_OK)
		status = scree_replay_restore(replay, pair->repeated);
	for (bool stepped = true; status == SCREE_OK && stepped;)
		status = scree_replay_step(replay, pair->repeated, &stepped);
	uint64_t hash = 0;
	if (status == SCREE_OK)
		status = scree_world_get_hash(pair->repeated, &hash);
	scree_replay_close(replay);
	if (status == SCREE_OK && hash != expected)
		return fail(SCREE_ERROR_DIFFERENT, "the hash of the replay differs");
	return status;
}

void recorded_end(Pair* pair, Outcome* outcome)
{
	if (!pair->records)
		return;
	const void* bytes;
	size_t size;
	uint64_t hash;
	scree_status status = scree_world_end_recording(pair->worlds[0]);
	if (status == SCREE_OK)
		status = scree_world_get_recording(pair->worlds[0], &bytes, &size);
	if (status == SCREE_OK && pair->record_path)
		write_file(pair->record_path, bytes, size);
	if (status == SCREE_OK)
		status = scree_world_get_hash(pair->worlds[0], &hash);
	if (status == SCREE_OK && !outcome->differs)
		status = repeat(pair, bytes, size, hash);
	if (status == SCREE_OK)
		return;
	outcome->differs = true;
	snprintf(outcome->sentence, sizeof outcome->sentence, "replay: %.240s", scree_error());
}
