// SPDX-License-Identifier: MIT
// call_codec.c -- writes the arguments and the results of a call as bytes, and reads them.
//
// The bytes of a call: the number of items, for a call with a count, a path or a snapshot; then each argument in order. An item
// is written member by member. An argument that may be null begins with 1, or is 0.
#include "world/record/call_codec.h"
#include "platform/error.h"
#include <string.h>

#define ALIGNMENT 16 // bytes: alignment of each argument in memory

// ---------------------------------------------------------------------------------------------------------------
// writing
// ---------------------------------------------------------------------------------------------------------------

static const void* pointer_at(const void* value)
{
	const void* pointer;
	memcpy(&pointer, value, sizeof pointer);
	return pointer;
}

static void items_write(ChunkWriter* writer, int id, const void* items, uint64_t count)
{
	const RecordedType* type = recorded_types + id;
	_Alignas(ALIGNMENT) uint8_t local[MOST_SIZE];
	for (uint64_t k = 0; k < count; ++k)
	{
		const char* item = type->definition ? definition_at(items, (int)k, type->definition, local)
		                                    : (const char*)items + k * (uint64_t)type->bytes;
		for (int m = 0; m < type->count; ++m)
			bytes_write(writer, item + type->members[m].offset, (size_t)type->members[m].bytes);
	}
}

static void maybe_write(ChunkWriter* writer, int id, const void* items, uint64_t count)
{
	number_write(writer, items != NULL);
	if (items)
		items_write(writer, id, items, count);
}

// Returns the number of items of a call, and writes it if the call has one.
static uint64_t count_write(ChunkWriter* writer, const RecordedCall* call, const void* const* values)
{
	for (int k = 0; k < call->count; ++k)
	{
		uint64_t count;
		ArgumentKind kind = call->arguments[k].kind;
		if (kind == ARGUMENT_COUNT)
			count = (uint64_t) * (const int*)values[k];
		else if (kind == ARGUMENT_SIZE)
			count = *(const size_t*)values[k];
		else if (kind == ARGUMENT_PATH)
			count = (uint64_t)((const scree_path_def*)pointer_at(values[k]))->count;
		else
			continue;
		number_write(writer, count);
		return count;
	}
	return 0;
}

void call_write(ChunkWriter* writer, RecordedCallId id, const void* const* values)
{
	const RecordedCall* call = recorded_calls + id;
	uint64_t count = count_write(writer, call, values);
	for (int k = 0; k < call->count; ++k)
	{
		int type = call->arguments[k].type;
		switch (call->arguments[k].kind)
		{
		case ARGUMENT_VALUE:
			items_write(writer, type, values[k], 1);
			break;
		case ARGUMENT_ARRAY:
			items_write(writer, type, pointer_at(values[k]), count);
			break;
		case ARGUMENT_PATH:
			items_write(writer, type, pointer_at(values[k]), 1);
			items_write(writer, RECORDED_TYPE_scree_vec, ((const scree_path_def*)pointer_at(values[k]))->points, count);
			break;
		case ARGUMENT_BYTES:
			bytes_write(writer, pointer_at(values[k]), (size_t)count);
			break;
		case ARGUMENT_POINTER:
		case ARGUMENT_RESULT:
			maybe_write(writer, type, pointer_at(values[k]), 1);
			break;
		case ARGUMENT_RESULTS:
			maybe_write(writer, type, pointer_at(values[k]), count);
			break;
		default:
			break;
		}
	}
}

// ---------------------------------------------------------------------------------------------------------------
// reading
// ---------------------------------------------------------------------------------------------------------------

typedef struct
{
	const FileLists* lists;
	ByteReader reader;
	CallArguments* to;
	size_t used;       // bytes of the memory that are in use
	uint64_t count;    // items of the call
	const char* fault; // null: none so far
} CallReader;

// Reads items; `to` null: only moves the reader on, and checks that the bytes exist.
static void items_read(CallReader* r, int id, void* to, uint64_t count)
{
	const RecordedType* type = recorded_types + id;
	const FileType* file = r->lists->by_id[id];
	bool known = file && count <= SIZE_MAX / (file->bytes + 1);
	const uint8_t* at = bytes_read(&r->reader, known ? (size_t)count * file->bytes : SIZE_MAX);
	for (uint64_t k = 0; k < count && at && to; ++k)
	{
		char* item = (char*)to + k * (uint64_t)type->bytes;
		if (type->definition)
			memcpy(item, &type->definition->bytes, sizeof type->definition->bytes);
		for (int m = 0; m < file->count; at += file->members[m++].bytes)
		{
			const RecordedMember* member = file->members + m;
			if (member->truth && *at > 1)
				r->fault = "has a bool that is neither 0 nor 1";
			for (int b = 0; member->offset < 0 && b < member->bytes; ++b)
				if (at[b] != 0)
					r->fault = "sets a member that this version of the library lacks";
			if (member->offset >= 0)
				memcpy(item + member->offset, at, (size_t)member->bytes);
		}
	}
}

// Returns memory for items, or null in the first pass, which only counts the bytes.
static void* room(CallReader* r, int id, uint64_t count)
{
	size_t bytes = (size_t)recorded_types[id].bytes * (size_t)count;
	void* at = r->to->memory ? r->to->memory + r->used : NULL;
	r->used += (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
	return at;
}

static bool present(CallReader* r)
{
	uint64_t flag = number_read(&r->reader);
	if (flag > 1)
		r->fault = "has a pointer that is neither 0 nor 1";
	return flag == 1;
}

static void argument_read(CallReader* r, const RecordedArgument* argument, int k)
{
	CallArguments* to = r->to;
	int type = argument->type;
	uint64_t count = argument->kind == ARGUMENT_ARRAY || argument->kind == ARGUMENT_RESULTS ? r->count : 1;
	to->values[k] = to->pointers + k;
	to->expected[k] = NULL;
	switch (argument->kind)
	{
	case ARGUMENT_COUNT:
		to->values[k] = &to->count;
		return;
	case ARGUMENT_SIZE:
		to->values[k] = &to->size;
		return;
	case ARGUMENT_BYTES:
		to->pointers[k] = (void*)(uintptr_t)bytes_read(&r->reader, (size_t)r->count);
		return;
	case ARGUMENT_POINTER:
		to->pointers[k] = NULL;
		if (!present(r))
			return;
		break;
	case ARGUMENT_RESULT:
	case ARGUMENT_RESULTS:
		if (present(r))
		{
			void* expected = room(r, type, count);
			items_read(r, type, expected, count);
			to->expected[k] = expected;
		}
		to->pointers[k] = room(r, type, count);
		return;
	default:
		break;
	}
	to->pointers[k] = room(r, type, count);
	items_read(r, type, to->pointers[k], count);
	if (argument->kind == ARGUMENT_VALUE)
		to->values[k] = to->pointers[k];
	if (argument->kind != ARGUMENT_PATH)
		return;
	scree_path_def* path = to->pointers[k];
	void* points = room(r, RECORDED_TYPE_scree_vec, r->count);
	items_read(r, RECORDED_TYPE_scree_vec, points, r->count);
	if (path)
	{
		path->points = points;
		path->count = (int)r->count;
	}
}

// Reads all arguments; the first pass has no memory and only counts the bytes.
static void pass(CallReader* r, const RecordedCall* call)
{
	bool counted = false;
	r->count = 0;
	r->used = 0;
	for (int k = 0; k < call->count; ++k)
		counted |= call->arguments[k].kind == ARGUMENT_COUNT || call->arguments[k].kind == ARGUMENT_SIZE ||
		           call->arguments[k].kind == ARGUMENT_PATH;
	if (counted)
		r->count = number_read(&r->reader);
	// each item has at least one byte in the file, so that a small file cannot demand much memory
	if (r->reader.at && r->count > (uint64_t)(r->reader.end - r->reader.at))
		r->reader.at = NULL;
	r->to->count = r->count > INT32_MAX ? -1 : (int)r->count;
	r->to->size = (size_t)r->count;
	for (int k = 0; k < call->count && r->reader.at; ++k)
		argument_read(r, call->arguments + k, k);
}

scree_status call_read(const char* function, const FileLists* lists, const LogRecord* record, CallArguments* arguments)
{
	uint64_t number = record->number - RECORD_CALLS;
	int id = number < (uint64_t)lists->call_count ? lists->calls[number] : -1;
	if (id < 0)
		return fail(SCREE_ERROR_INVALID, "%s: the recording has call %llu, which version %s of the library lacks",
		            function, (unsigned long long)number, scree_version());
	const RecordedCall* call = recorded_calls + id;
	uint8_t* memory = arguments->memory;
	arguments->memory = NULL;
	CallReader r = {.lists = lists, .reader = {record->bytes, record->bytes + record->size}, .to = arguments};
	ByteReader whole = r.reader;
	pass(&r, call);
	arguments->memory = memory;
	if (!r.reader.at || r.reader.at != r.reader.end)
		return fail(SCREE_ERROR_INVALID, "%s: a call of scree_%s has %zu bytes, which are not those of its arguments",
		            function, call->name, record->size);
	if (r.used + 1 > arguments->capacity)
	{
		arguments_close(arguments);
		arguments->memory = scree_allocate(r.used + 1);
		if (!arguments->memory)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a call of scree_%s with %zu bytes", function,
			            call->name, record->size);
		arguments->capacity = r.used + 1;
	}
	arguments->call = (RecordedCallId)id;
	memset(arguments->memory, 0, r.used);
	r.reader = whole;
	pass(&r, call);
	if (r.fault)
		return fail(SCREE_ERROR_INVALID, "%s: a call of scree_%s %s", function, call->name, r.fault);
	return SCREE_OK;
}

void arguments_close(CallArguments* arguments)
{
	scree_release(arguments->memory);
	arguments->memory = NULL;
	arguments->capacity = 0;
}

const char* results_differ(const CallArguments* arguments)
{
	const RecordedCall* call = recorded_calls + arguments->call;
	for (int k = 0; k < call->count; ++k)
	{
		const RecordedArgument* argument = call->arguments + k;
		size_t count = argument->kind == ARGUMENT_RESULTS ? (size_t)arguments->count : 1;
		if (arguments->expected[k] && memcmp(arguments->expected[k], arguments->pointers[k],
		                                     count * (size_t)recorded_types[argument->type].bytes) != 0)
			return argument->name;
	}
	return NULL;
}
