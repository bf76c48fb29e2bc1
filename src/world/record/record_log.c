// SPDX-License-Identifier: MIT
// record_log.c -- writes and reads the records of a recording.
#include "world/record/record_log.h"
#include "platform/error.h"
#include <string.h>

#define FORMAT_VERSION 1 // increased when older libraries cannot read new recordings
#define DIGEST_BYTES   4

// text conversions damage the last three bytes
static const char magic[8] = {'S', 'c', 'r', 'e', 'c', '\r', '\n', 26};

const uint8_t* bytes_read(ByteReader* reader, size_t size)
{
	const uint8_t* at = reader->at;
	if (!at || (size_t)(reader->end - at) < size)
		return reader->at = NULL;
	reader->at += size;
	return at;
}

void number_write(ChunkWriter* writer, uint64_t number)
{
	uint8_t bytes[10];
	size_t size = 0;
	for (; number > 127; number >>= 7)
		bytes[size++] = (uint8_t)(number | 128);
	bytes[size++] = (uint8_t)number;
	bytes_write(writer, bytes, size);
}

uint64_t number_read(ByteReader* reader)
{
	uint64_t number = 0;
	for (int shift = 0; shift < 64; shift += 7)
	{
		const uint8_t* byte = bytes_read(reader, 1);
		if (!byte)
			return 0;
		number |= (uint64_t)(*byte & 127) << shift;
		if (*byte < 128)
			return number;
	}
	reader->at = NULL;
	return 0;
}

// Adds bytes to a chain of digests.
static uint64_t chain_add(uint64_t chain, const uint8_t* bytes, size_t size)
{
	chain = (chain ^ chunks_digest(bytes, size)) * 0x9e3779b97f4a7c15u;
	return chain ^ chain >> 32;
}

void log_begin(ChunkWriter* writer, uint64_t* chain)
{
	size_t begin = writer->used;
	header_write(writer, magic, FORMAT_VERSION);
	if (writer->used != SIZE_MAX)
		*chain = chain_add(0, writer->bytes + begin, writer->used - begin);
}

void log_add(ChunkWriter* writer, uint64_t* chain, uint64_t number, const void* bytes, size_t size)
{
	size_t begin = writer->used;
	number_write(writer, number);
	number_write(writer, size);
	bytes_write(writer, bytes, size);
	if (writer->used == SIZE_MAX)
		return;
	*chain = chain_add(*chain, writer->bytes + begin, writer->used - begin);
	uint32_t digest = (uint32_t)*chain;
	bytes_write(writer, &digest, sizeof digest);
}

scree_status log_open(const char* function, ByteReader* reader, size_t size, uint64_t* chain, const char** version,
                      int* version_length)
{
	const uint8_t* begin = reader->at;
	const uint8_t* start = bytes_read(reader, sizeof magic);
	const uint8_t* numbers = bytes_read(reader, 2);
	if (!numbers || memcmp(start, magic, sizeof magic) != 0)
		return fail(SCREE_ERROR_INVALID, "%s: these %zu bytes are not a recording: they do not begin with \"Screc\"",
		            function, size);
	*version_length = numbers[1];
	*version = (const char*)bytes_read(reader, numbers[1]);
	if (!*version)
		return fail(SCREE_ERROR_INVALID, "%s: the recording is cut off in its first %zu bytes", function, size);
	if (numbers[0] > FORMAT_VERSION)
		return fail(
		    SCREE_ERROR_INVALID,
		    "%s: the recording has format %d, of library version %.*s; this version, %s, reads formats up to %d",
		    function, numbers[0], *version_length, *version, scree_version(), FORMAT_VERSION);
	*chain = chain_add(0, begin, (size_t)(reader->at - begin));
	return SCREE_OK;
}

static bool read_head(ByteReader* reader, LogRecord* record)
{
	record->number = number_read(reader);
	uint64_t size = number_read(reader);
	record->bytes = size <= SIZE_MAX ? bytes_read(reader, (size_t)size) : NULL;
	record->size = record->bytes ? (size_t)size : 0;
	return record->bytes != NULL;
}

bool log_next(ByteReader* reader, uint64_t* chain, LogRecord* record)
{
	ByteReader ahead = *reader;
	if (!read_head(&ahead, record))
		return false;
	uint64_t next = chain_add(*chain, reader->at, (size_t)(ahead.at - reader->at));
	uint32_t digest;
	const uint8_t* stored = bytes_read(&ahead, DIGEST_BYTES);
	if (!stored)
		return false;
	memcpy(&digest, stored, sizeof digest);
	if (digest != (uint32_t)next)
		return false;
	*chain = next;
	*reader = ahead;
	return true;
}

bool log_again(ByteReader* reader, LogRecord* record)
{
	return read_head(reader, record) && bytes_read(reader, DIGEST_BYTES) != NULL;
}
