// SPDX-License-Identifier: MIT
// format.c -- holds the table of the keys of scene files, and reads the values of all keys that need no special code.
#include "scene/format.h"
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define LIST(array, ...) const char* const array[] = {__VA_ARGS__, NULL};
#include "scene/format.def"

#define OBJECT(object, struct, value, text) typedef struct StructOf_##object;
#include "scene/format.def"

// clang-format off
#define STORE_OF(member) \
	_Generic((member), float: STORE_FLOAT, scree_vec: STORE_FLOAT, scree_rot: STORE_ROTATION, int: STORE_INT, \
	         int64_t: STORE_INT64, uint32_t: STORE_UINT32, uint64_t: STORE_UINT64, default: STORE_NONE)
#define NO_RANGE {0, 0, false, false}
// clang-format on
#define MEMBER(object, member) STORE_OF(((StructOf_##object*)0)->member), offsetof(StructOf_##object, member)

#define NUMBER(...)     TYPE_NUMBER, {__VA_ARGS__, false, false}, NULL
#define WHOLE(...)      TYPE_NUMBER, {__VA_ARGS__, true, false}, NULL
#define PAIR(...)       TYPE_PAIR, {__VA_ARGS__, false, false}, NULL
#define WHOLE_PAIR(...) TYPE_PAIR, {__VA_ARGS__, true, false}, NULL
#define ROTATION        TYPE_ROTATION, {-1.001, 1.001, false, false}, NULL
#define BOOLEAN         TYPE_BOOLEAN, NO_RANGE, NULL
#define BITS            TYPE_BITS, NO_RANGE, NULL
#define USER            TYPE_USER, NO_RANGE, NULL
#define NAME(list)      TYPE_NAME, NO_RANGE, list
#define NAMES(list)     TYPE_NAMES, NO_RANGE, list
#define POINTS(...)     TYPE_OTHER, {__VA_ARGS__, true, false}, NULL
#define OTHER           TYPE_OTHER, NO_RANGE, NULL
#define ATTRIBUTE       OTHER
#define BOX             OTHER
#define BY_NAME(of)     OTHER
#define CONSTANTS       OTHER
#define END             OTHER
#define LABEL           OTHER
#define MANY(of)        OTHER
#define NEW_NAME        OTHER
#define NEW_NAMES(of)   OTHER
#define ONE(of)         OTHER
#define ONE_OR_NULL(of) OTHER
#define PATH_POINTS(of) OTHER
#define REPEAT          OTHER
#define TEXT            TYPE_TEXT, NO_RANGE, NULL
#define WORD            OTHER

static const FormatKey keys[] = {
#define X(object, key, need, type, member, unit, text) \
	{OBJECT_##object, key, NEED_##need, type, false, MEMBER(object, member)},
#define SPECIAL(object, key, need, type, unit, text) {OBJECT_##object, key, NEED_##need, type, true, STORE_NONE, 0},
#include "scene/format.def"
    {.object = FORMAT_OBJECTS}};

const FormatKey* format_keys(FormatObject object)
{
	const FormatKey* key = keys;
	while (key->object != object)
		++key;
	return key;
}

bool format_check(Reader* reader, const Location* location, const json_t* value, FormatObject object)
{
	if (!json_is_object(value))
		return reader_fail_value(reader, location, value, "must be an object, { ... }");
	const FormatKey *first = format_keys(object), *known = first;
	for (void* at = json_object_iter((json_t*)value); at; at = json_object_iter_next((json_t*)value, at))
	{
		const char* name = json_object_iter_key(at);
		for (known = first; known->object == object && strcmp(known->name, name) != 0;)
			++known;
		const json_t* member = json_object_iter_value(at);
		if (known->object == object && known->type == TYPE_TEXT && !json_is_string(member))
			return reader_fail_value(reader, KEY(location, name), member, "must be a string");
		if (known->object == object)
			continue;

		char list[360] = "";
		for (known = first; known->object == object; ++known)
			snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s", known == first ? "" : ", ", known->name);
		return reader_fail(reader, location, "unknown key \"%.40s\"; known are %s", name, list);
	}
	return true;
}

// Returns the coordinate of a free joint. Its limits are NaN, which means that there are none; keys of the file replace
// them.
static scree_joint_coordinate new_coordinate(void)
{
	scree_joint_coordinate made = scree_joint_def_make(SCREE_JOINT_FREE).coordinates[SCREE_ALONG];
	made.lower = made.upper = NAN;
	return made;
}

// Returns a side of a gear whose angle is NaN, which means that it is that of the bodies at the start.
static scree_joint_side new_side(void)
{
	scree_joint_side made = scree_joint_def_make(SCREE_JOINT_GEAR).sides[0];
	made.initial_angle = NAN;
	return made;
}

void format_default(FormatObject object, void* target)
{
	switch (object)
	{
#define OBJECT(object, struct, value, text) \
	case OBJECT_##object:                   \
		*(struct*)target = value;           \
		break;
#include "scene/format.def"
	default:
		break;
	}
}

void format_store(void* item, size_t offset, FormatStore store, double value)
{
	void* member = (char*)item + offset;
	switch (store)
	{
	case STORE_FLOAT:
		*(float*)member = (float)value;
		break;
	case STORE_ROTATION:
		*(scree_rot*)member = (float)value == 0.0f ? (scree_rot){1.0f, 0.0f} : scree_rot_make((float)value);
		break;
	case STORE_INT:
		*(int*)member = (int)value;
		break;
	case STORE_INT64:
		*(int64_t*)member = (int64_t)value;
		break;
	case STORE_UINT32:
		*(uint32_t*)member = (uint32_t)value;
		break;
	case STORE_UINT64:
		*(uint64_t*)member = (uint64_t)value;
		break;
	case STORE_NONE:
		break;
	}
}

double format_stored(const void* item, size_t offset, FormatStore store)
{
	const void* member = (const char*)item + offset;
	switch (store)
	{
	case STORE_FLOAT:
		return (double)*(const float*)member;
	case STORE_ROTATION:
		return (double)scree_rot_get_angle(*(const scree_rot*)member);
	case STORE_INT:
		return *(const int*)member;
	case STORE_INT64:
		return (double)*(const int64_t*)member;
	case STORE_UINT32:
		return *(const uint32_t*)member;
	case STORE_UINT64:
		return (double)*(const uint64_t*)member;
	case STORE_NONE:
		break;
	}
	return (double)NAN;
}

Range format_range(FormatObject object, const char* name)
{
	const FormatKey* key = format_keys(object);
	while (strcmp(key->name, name) != 0)
		++key;
	return key->range;
}

static bool add_number(Reader* reader, const Location* location, size_t offset, FormatStore store, Number number,
                       FormatNumbers* numbers)
{
	FormatNumber* list = realloc(numbers->list, ((size_t)numbers->count + 1) * sizeof *list);
	if (!list)
	{
		number_free(&number);
		return reader_fail(reader, location, "out of memory");
	}
	list[numbers->count++] = (FormatNumber){offset, store, number};
	numbers->list = list;
	return true;
}

static bool read_number(Reader* reader, const Location* location, const json_t* value, const FormatKey* key, void* item,
                        size_t offset, FormatNumbers* numbers)
{
	Number number;
	if (!reader_number(reader, location, value, key->range, &number))
	{
		number_free(&number);
		return false;
	}
	if (number.code)
		return add_number(reader, location, offset, key->store, number, numbers);
	format_store(item, offset, key->store, number.constant);
	return true;
}

static bool read_pair(Reader* reader, const Location* location, const json_t* value, const FormatKey* key, void* item,
                      size_t offset, FormatNumbers* numbers)
{
	if (!json_is_array(value) || json_array_size(value) != 2)
		return reader_fail_value(reader, location, value, "must be a list of 2 numbers");
	return read_number(reader, ELEMENT(location, 0), json_array_get(value, 0), key, item, offset, numbers) &&
	       read_number(reader, ELEMENT(location, 1), json_array_get(value, 1), key, item, offset + sizeof(float),
	                   numbers);
}

// Reads a cosine and a sine. Their tolerance is that of scree.h.
static bool read_rotation(Reader* reader, const Location* location, const json_t* value, const FormatKey* key,
                          scree_rot* rotation)
{
	scree_vec v;
	if (!json_is_array(value) || !json_is_number(json_array_get(value, 0)) || !json_is_number(json_array_get(value, 1)))
		return reader_fail_value(reader, location, value, "must be a list of 2 numbers, without expressions");
	if (!reader_vec(reader, location, value, key->range, &v))
		return false;
	double square = (double)v.x * v.x + (double)v.y * v.y;
	if (!(square > 1.0 - 1e-3 && square < 1.0 + 1e-3))
		return reader_fail_value(reader, location, value, "must be the cosine and sine of an angle");
	*rotation = (scree_rot){v.x, v.y};
	return true;
}

static bool read_value(Reader* reader, const Location* location, const json_t* value, const FormatKey* key, void* item,
                       size_t offset, FormatNumbers* numbers)
{
	void* member = (char*)item + offset;
	switch (key->type)
	{
	case TYPE_NUMBER:
		return read_number(reader, location, value, key, item, offset, numbers);
	case TYPE_PAIR:
		return read_pair(reader, location, value, key, item, offset, numbers);
	case TYPE_ROTATION:
		return read_rotation(reader, location, value, key, member);
	case TYPE_BOOLEAN:
		return reader_boolean(reader, location, value, member);
	case TYPE_BITS:
		return reader_bits(reader, location, value, member);
	case TYPE_USER:
		return reader_user(reader, location, value, member);
	case TYPE_NAME:
		return reader_name(reader, location, value, key->names, member);
	case TYPE_NAMES:
		return reader_names(reader, location, value, key->names, member);
	case TYPE_TEXT:
	case TYPE_OTHER:
		break;
	}
	return true;
}

bool format_read(Reader* reader, const Location* location, const json_t* value, FormatObject object, void* item,
                 size_t offset, FormatNumbers* numbers)
{
	for (const FormatKey* key = format_keys(object); key->object == object; ++key)
	{
		const json_t* member = json_object_get(value, key->name);
		if (key->special || (!member && key->need != NEED_MUST))
			continue;
		if (!member && key->type != TYPE_NAME)
			return reader_fail(reader, location, "%s is missing", key->name);
		if (key->type == TYPE_ROTATION && json_object_get(value, "angle"))
			return reader_fail(reader, location, "both angle and %s; one of them is enough", key->name);
		if (!read_value(reader, KEY(location, key->name), member, key, item, offset + key->offset, numbers))
			return false;
	}
	return true;
}

void format_free(FormatNumbers* numbers)
{
	for (int k = 0; k < numbers->count; ++k)
		number_free(&numbers->list[k].number);
	free(numbers->list);
	*numbers = (FormatNumbers){0};
}
