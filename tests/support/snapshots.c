// SPDX-License-Identifier: MIT
// snapshots.c -- changes the chunks of snapshots, and checks that they are refused.
#include "support/snapshots.h"
#include "support/make_worlds.h"
#include "world/snapshot/chunks.h"

Saved copy_chunks(Saved saved, const char* left_out, const char* added, int bytes, int count, const void* values)
{
	ChunkIndex index;
	ChunkWriter writer = {0};
	OK(chunks_open(&index, "test", saved.bytes, saved.size));
	OK(chunks_begin(&writer, "test"));
	for (uint32_t k = 0; k < index.size; ++k)
	{
		const Chunk* chunk = index.chunks + k;
		char name[CHUNK_NAME + 1] = "";
		memcpy(name, chunk->name ? chunk->name : "", (size_t)chunk->name_length);
		if (chunk->name_length == 0 || (left_out && strcmp(name, left_out) == 0))
			continue;
		int stored = chunk->equal ? 1 : chunk->count;
		memcpy(chunk_add(&writer, name, chunk->bytes, chunk->count, stored), chunk->first,
		       (size_t)chunk->bytes * (size_t)stored);
	}
	if (added)
		memcpy(chunk_add(&writer, added, bytes, count, count), values, (size_t)bytes * (size_t)count);
	OK(chunks_end(&writer, "test"));
	chunks_close(&index);
	Saved copy = copy_of(writer.bytes, writer.used);
	scree_release(writer.bytes);
	return copy;
}

void refuse_snapshot(scree_world* world, const void* bytes, size_t size, const char* words)
{
	uint64_t hash = hash_of(world);
	scree_world* made;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	if (scree_world_restore(world, bytes, size) != SCREE_ERROR_INVALID)
		fail_msg("a snapshot is accepted, and should be refused by \"%s\"", words);
	if (!strstr(scree_error(), words))
		fail_msg("\"%s\" does not contain \"%s\"", scree_error(), words);
	assert_int_equal(scree_world_create_from(&def, bytes, size, &made), SCREE_ERROR_INVALID);
	assert_null(made);
	assert_true(hash_of(world) == hash);
}
