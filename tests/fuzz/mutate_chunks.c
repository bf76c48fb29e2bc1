// SPDX-License-Identifier: MIT
// mutate_chunks.c -- changes a file of chunks (docs/design/snapshots.md) at random, and keeps it a file of chunks.
//
// Bytes that are changed without this knowledge are almost always refused at once: a chunk must have as many values as
// counters in other chunks state.
#include "fuzz/mutate_chunks.h"
#include "tools/common/random_numbers.h"
#include <stdbool.h>
#include <string.h>

#define MOST_CHUNKS 2048
#define VERSION_AT  8 // offset of the version of the format; the length of the library's version follows
#define DIGEST      8

typedef struct
{
	size_t at;     // offset of the length of its name
	size_t values; // offset of its values
	size_t end;
	bool equal;
	uint16_t bytes; // bytes of a value
	uint32_t count;
} Part;

typedef struct
{
	uint8_t* bytes;
	size_t size, most;
	uint64_t seed;
	Part parts[MOST_CHUNKS];
	int count;
	size_t end; // offset of the byte behind the last chunk
} Chunks;

static bool find_parts(Chunks* c)
{
	c->count = 0;
	if (c->size < VERSION_AT + 2)
		return false;
	size_t at = VERSION_AT + 2 + (size_t)c->bytes[VERSION_AT + 1];
	while (c->count < MOST_CHUNKS && at < c->size && c->bytes[at] > 0)
	{
		Part* part = c->parts + c->count;
		size_t head = at + 1 + c->bytes[at];
		if (head + 7 > c->size)
			return false;
		part->at = at;
		part->equal = c->bytes[head] != 0;
		memcpy(&part->bytes, c->bytes + head + 1, sizeof part->bytes);
		memcpy(&part->count, c->bytes + head + 3, sizeof part->count);
		part->values = head + 7;
		uint64_t stored = (uint64_t)part->bytes * (part->equal && part->count > 0 ? 1 : part->count);
		if (stored > c->size - part->values)
			return false;
		part->end = at = part->values + (size_t)stored;
		++c->count;
	}
	c->end = at;
	return c->count > 0 && at < c->size;
}

static Part* any_part(Chunks* c) { return c->parts + random_below(&c->seed, c->count); }

// Replaces `removed` bytes at an offset by `added` bytes, whose values are those of the bytes before or of `from`.
static bool splice(Chunks* c, size_t at, size_t removed, const uint8_t* from, size_t added)
{
	if (c->size - removed + added > c->most)
		return false;
	memmove(c->bytes + at + added, c->bytes + at + removed, c->size - at - removed);
	if (from)
		memcpy(c->bytes + at, from, added);
	c->size = c->size - removed + added;
	return true;
}

uint32_t mutate_word(uint32_t old, uint64_t* seed)
{
	static const uint32_t words[] = {0,          1,          2,          3,          64,         65,
	                                 255,        256,        1u << 16,   1u << 24,   0x7fffffff, 0x80000000,
	                                 0xffffffff, 0xfffffffe, 0x7f800000, 0xff800000, 0x7fc00000, 0x7f7fffff,
	                                 0x3f800000, 0xbf800000, 0x00000001};
	uint64_t any = random_word(seed);
	switch (any % 5)
	{
	case 0:
		return old + 1 + (uint32_t)(any >> 32) % 3;
	case 1:
		return old - 1 - (uint32_t)(any >> 32) % 3;
	case 2:
		return old ^ 1u << (any >> 32) % 32;
	case 3:
		return (uint32_t)(any >> 32) % 12;
	default:
		return words[(any >> 32) % (sizeof words / sizeof *words)];
	}
}

static void change_value(Chunks* c)
{
	Part* part = any_part(c);
	size_t length = part->end - part->values;
	if (length == 0)
		return;
	size_t unit = length % 4 == 0 ? 4 : 1, at = part->values + random_word(&c->seed) % (length / unit) * unit;
	uint32_t word = 0;
	memcpy(&word, c->bytes + at, unit);
	word = mutate_word(word, &c->seed);
	if (unit == 1 && part->bytes == 1)
		word &= 1; // truths
	memcpy(c->bytes + at, &word, unit);
}

// Copies a value of a column to another place of the column.
static void copy_value(Chunks* c)
{
	Part* part = any_part(c);
	if (part->equal || part->count < 2 || part->bytes == 0)
		return;
	uint32_t from = (uint32_t)random_below(&c->seed, (int)part->count);
	uint32_t to = (uint32_t)random_below(&c->seed, (int)part->count);
	memmove(c->bytes + part->values + (size_t)to * part->bytes, c->bytes + part->values + (size_t)from * part->bytes,
	        part->bytes);
}

// Stores all values of a column, or only one.
static void change_equal(Chunks* c)
{
	Part part = *any_part(c);
	size_t length = (size_t)part.bytes * part.count;
	if (part.count < 2 || part.bytes == 0 || (part.equal && part.count > 4096))
		return;
	if (!part.equal)
	{
		splice(c, part.values + part.bytes, length - part.bytes, NULL, 0);
		c->bytes[part.values - 7] = 1;
		return;
	}
	uint8_t value[256];
	if (part.bytes > sizeof value)
		return;
	memcpy(value, c->bytes + part.values, part.bytes);
	if (!splice(c, part.values + part.bytes, 0, NULL, length - part.bytes))
		return;
	for (uint32_t k = 1; k < part.count; ++k)
		memcpy(c->bytes + part.values + (size_t)k * part.bytes, value, part.bytes);
	c->bytes[part.values - 7] = 0;
}

// Changes the number of values of a column. Returns false if there is no room.
static bool set_count(Chunks* c, const Part* part, uint32_t count)
{
	size_t old = part->end - part->values;
	size_t length = part->equal ? (count > 0 ? part->bytes : 0) : (size_t)part->bytes * count;
	if (!part->equal && count > part->count + 64)
		return false;
	if (length > old)
	{
		if (!splice(c, part->end, 0, NULL, length - old))
			return false;
		for (size_t at = part->end; at < part->end + length - old; ++at)
			c->bytes[at] = part->bytes > 0 && old >= part->bytes ? c->bytes[at - part->bytes] : 0;
	}
	else
		splice(c, part->values + length, old - length, NULL, 0);
	memcpy(c->bytes + part->values - 4, &count, sizeof count);
	return true;
}

static void change_count(Chunks* c)
{
	Part part = *any_part(c);
	set_count(c, &part, mutate_word(part.count, &c->seed) & (part.equal ? 0xffffffffu : 0xffffu));
}

// Changes the number of values of all columns of one length, and the counters that have this number.
static void change_counts(Chunks* c)
{
	uint32_t old = any_part(c)->count, count = random_below(&c->seed, 4) ? old + 1 : old - 1;
	bool half = random_below(&c->seed, 2);
	for (int k = c->count - 1; k >= 0 && old > 1; --k)
	{
		uint32_t word = 0;
		const Part part = c->parts[k];
		if (part.count == old)
			set_count(c, &part, count);
		else if (part.count == 1 && part.bytes == 4)
		{
			memcpy(&word, c->bytes + part.values, 4);
			if (word == old && !(half && random_below(&c->seed, 2)))
				memcpy(c->bytes + part.values, &count, 4);
		}
	}
}

static void drop_chunk(Chunks* c)
{
	const Part* part = any_part(c);
	splice(c, part->at, part->end - part->at, NULL, 0);
}

static void repeat_chunk(Chunks* c)
{
	const Part part = *any_part(c);
	uint8_t copy[4096];
	size_t length = part.end - part.at;
	if (length > sizeof copy)
		return;
	memcpy(copy, c->bytes + part.at, length);
	if (splice(c, c->end, 0, copy, length) && random_below(&c->seed, 4))
		++c->bytes[c->end + 1]; // another name
}

size_t mutate_chunks(uint8_t* bytes, size_t size, size_t most, uint64_t seed)
{
	static Chunks c;
	static void (*const changes[])(Chunks*) = {change_value, change_value,  change_value, copy_value, copy_value,
	                                           change_equal, change_counts, change_count, drop_chunk, repeat_chunk};
	c = (Chunks){.bytes = bytes, .size = size, .most = most, .seed = seed};
	for (int k = 1 + random_below(&c.seed, 4); k > 0; --k)
	{
		if (!find_parts(&c))
			return c.size == size ? 0 : c.size;
		changes[random_below(&c.seed, (int)(sizeof changes / sizeof *changes))](&c);
	}
	return c.size;
}
