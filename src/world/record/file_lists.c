// SPDX-License-Identifier: MIT
// file_lists.c -- writes the types and calls of this library into a recording, and reads those of another version.
#include "world/record/file_lists.h"
#include "platform/error.h"
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// writing
// ---------------------------------------------------------------------------------------------------------------

static void name_write(ChunkWriter* writer, const char* name)
{
	number_write(writer, strlen(name));
	bytes_write(writer, name, strlen(name));
}

void lists_write(ChunkWriter* writer)
{
	number_write(writer, RECORDED_TYPES);
	for (int t = 0; t < RECORDED_TYPES; ++t)
	{
		const RecordedType* type = recorded_types + t;
		name_write(writer, type->name);
		number_write(writer, (uint64_t)type->count);
		for (int m = 0; m < type->count; ++m)
		{
			name_write(writer, type->members[m].name);
			number_write(writer, (uint64_t)type->members[m].bytes);
		}
	}
	number_write(writer, RECORDED_CALLS);
	for (int c = 0; c < RECORDED_CALLS; ++c)
	{
		const RecordedCall* call = recorded_calls + c;
		name_write(writer, call->name);
		number_write(writer, (uint64_t)call->count);
		for (int k = 0; k < call->count; ++k)
		{
			number_write(writer, call->arguments[k].kind);
			number_write(writer, (uint64_t)(call->arguments[k].type + 1));
		}
	}
}

// ---------------------------------------------------------------------------------------------------------------
// reading
// ---------------------------------------------------------------------------------------------------------------

typedef struct
{
	const char* first; // not terminated
	int length;
} Name;

static Name name_read(ByteReader* reader)
{
	uint64_t length = number_read(reader);
	const uint8_t* first = bytes_read(reader, length > 255 ? SIZE_MAX : (size_t)length);
	return (Name){(const char*)first, first ? (int)length : 0};
}

static bool is_name(Name name, const char* text)
{
	return (size_t)name.length == strlen(text) && memcmp(name.first, text, (size_t)name.length) == 0;
}

// Returns a number of items that have at least one byte each in the rest of the file.
static int items_read(ByteReader* reader)
{
	uint64_t count = number_read(reader);
	if (reader->at && count <= (uint64_t)(reader->end - reader->at) && count <= INT32_MAX)
		return (int)count;
	reader->at = NULL;
	return 0;
}

static RecordedMember member_of(int type, Name name, int bytes)
{
	for (int m = 0; type >= 0 && m < recorded_types[type].count; ++m)
	{
		const RecordedMember* member = recorded_types[type].members + m;
		if (is_name(name, member->name) && member->bytes == bytes)
			return *member;
	}
	return (RecordedMember){.offset = -1, .bytes = bytes};
}

static scree_status no_memory(const char* function)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for the list of calls", function);
}

static scree_status type_read(const char* function, ByteReader* reader, FileType* type)
{
	Name name = name_read(reader);
	type->id = RECORDED_TYPES - 1;
	while (type->id >= 0 && !is_name(name, recorded_types[type->id].name))
		--type->id;
	type->count = items_read(reader);
	type->members = scree_allocate((size_t)type->count * sizeof *type->members);
	if (!type->members)
		return no_memory(function);
	for (int m = 0; m < type->count && reader->at; ++m)
	{
		Name member = name_read(reader);
		uint64_t bytes = number_read(reader);
		if (bytes < 1 || bytes > MOST_SIZE)
			reader->at = NULL;
		else if (reader->at)
			type->members[m] = member_of(type->id, member, (int)bytes);
		type->bytes += (size_t)type->members[m].bytes;
	}
	return SCREE_OK;
}

// Returns the call of this library with the name and the arguments of a call of the file, or -1.
static int file_call_read(ByteReader* reader, const FileLists* lists)
{
	Name name = name_read(reader);
	int count = items_read(reader), id = reader->at ? RECORDED_CALLS - 1 : -1;
	while (id >= 0 && !is_name(name, recorded_calls[id].name))
		--id;
	bool same = id >= 0 && count == recorded_calls[id].count;
	for (int k = 0; k < count && reader->at; ++k)
	{
		uint64_t kind = number_read(reader), type = number_read(reader);
		if (type > (uint64_t)lists->type_count)
			reader->at = NULL;
		int type_id = type > 0 && reader->at ? lists->types[type - 1].id : -1;
		same = same && kind == recorded_calls[id].arguments[k].kind && type_id == recorded_calls[id].arguments[k].type;
	}
	return same ? id : -1;
}

static scree_status read_all(const char* function, ByteReader* reader, FileLists* lists)
{
	int types = items_read(reader);
	lists->types = scree_allocate((size_t)types * sizeof *lists->types);
	if (!lists->types)
		return no_memory(function);
	lists->type_count = types;
	for (int t = 0; t < types && reader->at; ++t)
	{
		FileType* type = lists->types + t;
		TRY(type_read(function, reader, type));
		if (type->id >= 0)
			lists->by_id[type->id] = type;
	}
	int calls = items_read(reader);
	lists->calls = scree_allocate((size_t)calls * sizeof *lists->calls);
	if (!lists->calls)
		return no_memory(function);
	lists->call_count = calls;
	for (int c = 0; c < calls && reader->at; ++c)
		lists->calls[c] = file_call_read(reader, lists);
	if (!reader->at || reader->at != reader->end)
		return fail(SCREE_ERROR_INVALID, "%s: the recording's list of calls is damaged", function);
	return SCREE_OK;
}

scree_status lists_read(const char* function, ByteReader* reader, FileLists* lists)
{
	*lists = (FileLists){0};
	scree_status status = read_all(function, reader, lists);
	if (status != SCREE_OK)
		lists_close(lists);
	return status;
}

void lists_close(FileLists* lists)
{
	for (int t = 0; t < lists->type_count; ++t)
		scree_release(lists->types[t].members);
	scree_release(lists->types);
	scree_release(lists->calls);
	*lists = (FileLists){0};
}
