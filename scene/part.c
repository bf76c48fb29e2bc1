// SPDX-License-Identifier: MIT
// part.c -- reads the collidables of a block's items: attribute, pose in the body, filter.
#include "scene/part.h"
#include "scene/attribute_block.h"
#include "scene/loop.h"
#include <stdlib.h>
#include <string.h>

static bool read_attribute_name(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                                int* found)
{
	const char* name;
	return reader_string(reader, location, value, &name) && attributes_find(scene, reader, location, name, found);
}

static bool read_choice(Reader* reader, const Location* location, const json_t* object, const Scene* scene,
                        Choice* choice)
{
	const json_t* value = json_object_get(object, "attribute");
	const json_t* choose = json_object_get(object, "choose");
	const Location* at = KEY(location, "attribute");
	if (!value)
		return reader_fail(reader, location, "attribute is missing");
	bool list = json_is_array(value);
	choice->count = list ? (int)json_array_size(value) : 1;
	if (choice->count == 0)
		return reader_fail(reader, at, "an empty list");
	if (!reader_claim(reader, at, (size_t)choice->count * sizeof(int)))
		return false;
	choice->attributes = calloc((size_t)choice->count, sizeof(int));
	if (!choice->attributes)
		return reader_fail(reader, at, "out of memory");
	for (int k = 0; k < choice->count; ++k)
	{
		const json_t* name = list ? json_array_get(value, (size_t)k) : value;
		if (!read_attribute_name(reader, list ? ELEMENT(at, k) : at, name, scene, &choice->attributes[k]))
			return false;
	}
	if (choice->count == 1 && choose)
		return reader_fail(reader, location, "choose needs a list of attributes to choose from");
	if (choice->count > 1 && !choose)
		return reader_fail(reader, location,
		                   "a list of attributes needs choose, an expression that picks one by position");
	// range of the position; its whole part is used, so that random(0, 3) selects evenly from 3 attributes
	Range range = {0, choice->count - 1, false, true};
	return reader_member(reader, location, object, "choose", range, 0, &choice->choose);
}

// Reads a part as an object of the format: an entry of a body's collidables, or a collidable without a body.
static bool read_part(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      FormatObject object, Part* part)
{
	format_default(object, &part->def);
	return read_choice(reader, location, value, scene, &part->choice) &&
	       format_read(reader, location, value, object, &part->def, 0, &part->numbers);
}

// Adds empty parts to a list and returns the first new part, or null if memory is short.
static Part* add_parts(Parts* parts, int count)
{
	Part* list = realloc(parts->list, (size_t)(parts->count + count) * sizeof(Part));
	if (!list)
		return NULL;
	parts->list = list;
	memset(list + parts->count, 0, (size_t)count * sizeof(Part));
	parts->count += count;
	return list + parts->count - count;
}

// Reads one entry of a body's collidables. An entry with a repeat is read once for each value of the index, with the
// index as a constant. So all items of a block have the same number of collidables.
static bool read_part_entry(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                            Parts* parts)
{
	if (!format_check(reader, location, value, OBJECT_part))
		return false;
	const json_t* repeat = json_object_get(value, "repeat");
	Loop loop = {0};
	int first = 0, count = 1;
	if (repeat)
	{
		const Location* at = KEY(location, "repeat");
		if (!loop_read(reader, at, repeat, &loop))
		{
			loop_free(&loop);
			return false;
		}
		bool varies = loop.first.code || loop.end.code;
		first = (int)loop.first.constant;
		double span = loop.end.constant - loop.first.constant;
		loop_free(&loop);
		if (varies || span < 0 || span > MAX_PARTS - parts->count)
			return reader_fail(reader, at, "must give the same 0 to %d collidables to each body", MAX_PARTS);
		count = (int)span;
	}
	if (!reader_claim(reader, location, (size_t)count * sizeof(Part)))
		return false;
	Part* part = add_parts(parts, count);
	if (!part)
		return reader_fail(reader, location, "out of memory");
	for (int k = 0; k < count; ++k)
	{
		int names = reader->scope.count;
		if (repeat && !loop_add_index(reader, location, &loop, -1, first + k))
			return false;
		if (!read_part(reader, location, value, scene, OBJECT_part, &part[k]))
			return false;
		reader->scope.count = names;
	}
	return true;
}

bool parts_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Parts* parts)
{
	const json_t* list = json_object_get(value, "collidables");
	parts->simple = !list;
	if (!list)
	{
		Part* part = add_parts(parts, 1);
		if (!part)
			return reader_fail(reader, location, "out of memory");
		return bodies ? read_choice(reader, location, value, scene, &part->choice)
		              : read_part(reader, location, value, scene, OBJECT_collidable, part);
	}
	if (!reader_list(reader, KEY(location, "collidables"), list))
		return false;
	for (const FormatKey* key = format_keys(OBJECT_body); key->object == OBJECT_body; ++key)
	{
		bool each = key->need == NEED_ALONE || strcmp(key->name, "attribute") == 0;
		if (each && json_object_get(value, key->name))
			return reader_fail(reader, location, "%s belongs into each of the collidables", key->name);
	}
	for (int k = 0; k < (int)json_array_size(list); ++k)
	{
		const Location* at = ELEMENT(KEY(location, "collidables"), k);
		if (!read_part_entry(reader, at, json_array_get(list, (size_t)k), scene, parts))
			return false;
	}
	return true;
}

void parts_free(Parts* parts)
{
	for (int k = 0; k < parts->count; ++k)
	{
		Part* part = &parts->list[k];
		free(part->choice.attributes);
		number_free(&part->choice.choose);
		format_free(&part->numbers);
	}
	free(parts->list);
}
