// SPDX-License-Identifier: MIT
// loop.c -- reads the repeat loops of a block: an index that runs over a range of whole numbers.
#include "scene/loop.h"
#include "scene/format.h"
#include <string.h>

bool loop_read(Reader* reader, const Location* location, const json_t* value, Loop* loop)
{
	const char* index;
	if (!format_check(reader, location, value, OBJECT_loop))
		return false;
	if (!json_object_get(value, "to"))
		return reader_fail(reader, location, "to is missing");
	if (!reader_string(reader, KEY(location, "index"), json_object_get(value, "index"), &index))
		return false;
	if (!name_is_allowed(index) || scope_find(&reader->scope, index))
		return reader_fail(reader, KEY(location, "index"), "\"%.40s\" is taken or is no name in small letters", index);
	strcpy(loop->index, index);
	return reader_member(reader, location, value, "from", format_range(OBJECT_loop, "from"), 0, &loop->first) &&
	       reader_member(reader, location, value, "to", format_range(OBJECT_loop, "to"), 0, &loop->end);
}

bool loop_add_index(Reader* reader, const Location* location, const Loop* loop, int slot, double value)
{
	if (reader->scope.count == MAX_NAMES)
		return reader_fail(reader, location, "more than %d names", MAX_NAMES);
	Name* name = &reader->scope.names[reader->scope.count++];
	*name = (Name){.slot = slot, .value = value};
	strcpy(name->text, loop->index);
	return true;
}

bool loops_read(Reader* reader, const Location* location, const json_t* object, Loops* loops)
{
	const json_t* value = json_object_get(object, "repeat");
	const Location* repeat = KEY(location, "repeat");
	if (!value)
		return true;
	bool list = json_is_array(value);
	size_t count = list ? json_array_size(value) : 1;
	if (count == 0 || count > MAX_LOOPS)
		return reader_fail(reader, repeat, "%zu nested ranges, must be 1 to %d", count, MAX_LOOPS);
	for (int k = 0; k < (int)count; ++k)
	{
		const json_t* entry = list ? json_array_get(value, (size_t)k) : value;
		const Location* at = list ? ELEMENT(repeat, k) : repeat;
		++loops->count;
		if (!loop_read(reader, at, entry, &loops->list[k]) || !loop_add_index(reader, at, &loops->list[k], k, 0))
			return false;
	}
	return true;
}

void loop_free(Loop* loop)
{
	number_free(&loop->first);
	number_free(&loop->end);
}

void loops_free(Loops* loops)
{
	for (int k = 0; k < loops->count; ++k)
		loop_free(&loops->list[k]);
}
