// SPDX-License-Identifier: MIT
// moment_file.c -- writes and reads snapshots with parts of a program, as further chunks: a library that reads the snapshot skips
// chunks that it lacks.
#include "scene/moment_file.h"
#include "world/snapshot/chunks.h"
#include <string.h>

scree_status moment_write(scree_world* world, const FilePart* parts, int count, const void** bytes, size_t* size)
{
	scree_status status = scree_world_snapshot(world, bytes, size);
	if (status != SCREE_OK)
		return status;
	ChunkWriter* writer = &world->snapshot;
	chunks_continue(writer);
	for (int k = 0; k < count; ++k)
	{
		int values = (int)(parts[k].bytes / (size_t)parts[k].unit);
		uint8_t* to = values > 0 ? chunk_add(writer, parts[k].name, parts[k].unit, values, values) : NULL;
		if (to)
			memcpy(to, parts[k].values, parts[k].bytes);
	}
	status = chunks_end(writer, "moment_write");
	*bytes = writer->bytes;
	*size = writer->used;
	return status;
}

scree_status moment_read(const void* bytes, size_t size, FilePart* parts, int count)
{
	ChunkIndex index;
	scree_status status = chunks_open(&index, "scree_world_restore", bytes, size);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		const Chunk* chunk = chunk_find(&index, parts[k].name);
		bool good = chunk && chunk->bytes == parts[k].unit && !chunk->equal;
		parts[k].values = good ? chunk->first : NULL;
		parts[k].bytes = good ? (size_t)chunk->bytes * (size_t)chunk->count : 0;
	}
	chunks_close(&index);
	return status;
}
