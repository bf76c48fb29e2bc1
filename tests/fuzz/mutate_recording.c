// SPDX-License-Identifier: MIT
// mutate_recording.c -- changes a recording (docs/design/recording.md) at random, and corrects the digests of its records.
#include "fuzz/mutate_recording.h"
#include "fuzz/mutate_chunks.h"
#include "tools/common/random_numbers.h"
#include "world/record/record_log.h"
#include <stdlib.h>
#include <string.h>

#define MOST_RECORDS 1024
#define MOST_CONTENT 65536 // bytes of the contents of all records

typedef struct // the records of a recording, with copies of their contents
{
	LogRecord records[MOST_RECORDS];
	int count;
	uint8_t contents[MOST_CONTENT];
	size_t used;
	uint64_t seed;
} Records;

// Returns memory for the content of a record, or null.
static uint8_t* content(Records* r, size_t size)
{
	if (size > sizeof r->contents - r->used)
		return NULL;
	r->used += size;
	return r->contents + r->used - size;
}

static void read_records(Records* r, ByteReader reader)
{
	r->count = 0;
	r->used = 0;
	while (r->count < MOST_RECORDS && reader.at < reader.end)
	{
		LogRecord record;
		uint8_t* copy = log_again(&reader, &record) ? content(r, record.size) : NULL;
		if (!copy)
			return;
		memcpy(copy, record.bytes, record.size);
		record.bytes = copy;
		r->records[r->count++] = record;
	}
}

// Writes the header and the records. Returns the size, 0 if they are larger than `most`.
static size_t write_records(Records* r, uint8_t* bytes, size_t most)
{
	ChunkWriter writer = {0};
	uint64_t chain = 0;
	log_begin(&writer, &chain);
	for (int k = 0; k < r->count; ++k)
	{
		const LogRecord* record = r->records + k;
		uint64_t digest;
		if (record->number == RECORD_SNAPSHOT && record->size > sizeof digest)
		{
			uint8_t* end = r->contents + (record->bytes - r->contents) + record->size - sizeof digest;
			digest = chunks_digest(record->bytes, record->size - sizeof digest);
			memcpy(end, &digest, sizeof digest);
		}
		log_add(&writer, &chain, record->number, record->bytes, record->size);
	}
	size_t size = writer.used <= most ? writer.used : 0;
	if (size > 0)
		memcpy(bytes, writer.bytes, size);
	scree_release(writer.bytes);
	return size;
}

// Reads the records of a recording whose header is that of this version.
static bool open_records(Records* r, const uint8_t* bytes, size_t size)
{
	ChunkWriter header = {0};
	uint64_t chain;
	log_begin(&header, &chain);
	bool same = header.used <= size && memcmp(header.bytes, bytes, header.used) == 0;
	if (same)
		read_records(r, (ByteReader){bytes + header.used, bytes + size});
	scree_release(header.bytes);
	return same && r->count > 0;
}

size_t recording_seal(const uint8_t* bytes, size_t size, uint8_t* sealed, size_t most)
{
	static Records r;
	return open_records(&r, bytes, size) ? write_records(&r, sealed, most) : 0;
}

// ---------------------------------------------------------------------------------------------------------------
// changes
// ---------------------------------------------------------------------------------------------------------------

// Returns a record behind the list of calls, most times.
static LogRecord* any_record(Records* r)
{
	int first = r->count > 2 && random_below(&r->seed, 32) > 0 ? 2 : 0;
	return r->records + first + random_below(&r->seed, r->count - first);
}

static void change_bytes(Records* r)
{
	LogRecord* record = any_record(r);
	uint8_t* bytes = r->contents + (record->bytes - r->contents);
	size_t unit = record->size >= 4 && random_below(&r->seed, 2) ? 4 : 1;
	if (record->size < unit)
		return;
	uint8_t* at = bytes + random_word(&r->seed) % (record->size - unit + 1);
	uint32_t word = 0;
	memcpy(&word, at, unit);
	word = mutate_word(word, &r->seed);
	memcpy(at, &word, unit);
}

static void change_length(Records* r)
{
	LogRecord* record = any_record(r);
	size_t size = (size_t)random_below(&r->seed, (int)record->size + 16);
	uint8_t* copy = content(r, size);
	if (!copy)
		return;
	memset(copy, 1, size);
	memcpy(copy, record->bytes, size < record->size ? size : record->size);
	record->bytes = copy;
	record->size = size;
}

static void change_number(Records* r)
{
	LogRecord* record = any_record(r);
	record->number = random_below(&r->seed, 4) ? RECORD_CALLS + (uint64_t)random_below(&r->seed, 128)
	                                           : (uint64_t)random_below(&r->seed, RECORD_CALLS);
}

static void change_snapshot(Records* r)
{
	LogRecord* record = r->records + 1;
	size_t most = record->size + 1024;
	uint8_t* copy = r->count > 1 && record->number == RECORD_SNAPSHOT ? content(r, most) : NULL;
	if (!copy)
		return;
	memcpy(copy, record->bytes, record->size);
	size_t size = mutate_chunks(copy, record->size, most, random_word(&r->seed));
	record->size = size > 0 ? size : record->size;
	record->bytes = copy;
}

static void drop_record(Records* r)
{
	LogRecord* record = any_record(r);
	memmove(record, record + 1, (size_t)(r->records + r->count - record - 1) * sizeof *record);
	--r->count;
}

static void repeat_record(Records* r)
{
	const LogRecord record = *any_record(r);
	uint8_t* copy = r->count < MOST_RECORDS ? content(r, record.size) : NULL;
	if (!copy)
		return;
	memcpy(copy, record.bytes, record.size);
	LogRecord* at = any_record(r);
	memmove(at + 1, at, (size_t)(r->records + r->count - at) * sizeof *at);
	*at = (LogRecord){record.number, copy, record.size};
	++r->count;
}

static void exchange_records(Records* r)
{
	LogRecord *a = any_record(r), *b = any_record(r), first = *a;
	*a = *b;
	*b = first;
}

size_t mutate_recording(uint8_t* bytes, size_t size, size_t most, uint64_t seed)
{
	static Records r;
	static void (*const changes[])(Records*) = {change_bytes,    change_bytes, change_bytes,  change_bytes,
	                                            change_snapshot, drop_record,  repeat_record, exchange_records,
	                                            change_length,   change_number};
	if (!open_records(&r, bytes, size))
		return 0;
	r.seed = seed;
	for (int k = 1 + random_below(&r.seed, 4); k > 0 && r.count > 0; --k)
		changes[random_below(&r.seed, (int)(sizeof changes / sizeof *changes))](&r);
	return write_records(&r, bytes, most);
}
