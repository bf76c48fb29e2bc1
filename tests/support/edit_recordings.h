// SPDX-License-Identifier: MIT
// edit_recordings.h -- copies recordings with other bytes and the right digests.
#ifndef EDIT_RECORDINGS_H
#define EDIT_RECORDINGS_H
#include "support/recordings.h"
#include "world/record/recorder.h"

// Changes the bytes of a record in place. k: number of the record in the file.
typedef void (*RecordEdit)(int k, const LogRecord* record, uint8_t* bytes, const void* context);

// Copies a recording record by record. The caller frees its bytes.
static inline Saved edit_recording(Saved saved, RecordEdit edit, const void* context)
{
	ByteReader reader = {saved.bytes, (const uint8_t*)saved.bytes + saved.size};
	uint64_t from, to;
	const char* version;
	int length;
	LogRecord record;
	ChunkWriter writer = {0};
	OK(log_open("test", &reader, saved.size, &from, &version, &length));
	log_begin(&writer, &to);
	for (int k = 0; log_next(&reader, &from, &record); ++k)
	{
		uint8_t* bytes = malloc(record.size + 1);
		memcpy(bytes, record.bytes, record.size);
		edit(k, &record, bytes, context);
		log_add(&writer, &to, record.number, bytes, record.size);
		free(bytes);
	}
	Saved copy = {malloc(writer.used), writer.used};
	memcpy(copy.bytes, writer.bytes, writer.used);
	scree_release(writer.bytes);
	return copy;
}

#endif
