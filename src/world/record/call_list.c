// SPDX-License-Identifier: MIT
// call_list.c -- the tables of recorded calls and of their types, which follow from the two lists.
#include "world/record/call_list.h"
#include <stddef.h>

// ---------------------------------------------------------------------------------------------------------------
// types
// ---------------------------------------------------------------------------------------------------------------

// clang-format off
#define TRUTH_OF(value)              _Generic(value, bool: true, default: false)
#define MEMBER_ROW(type, member) \
	{#member, (int)offsetof(type, member), (int)sizeof(((type*)0)->member), TRUTH_OF(((type*)0)->member)},

// The member of a plain type is the whole of it.
#define WHOLE(type, token)           static const RecordedMember members_##token[] = {{"", 0, (int)sizeof(type), TRUTH_OF(*(type*)0)}};
#define PLAIN(type)                  WHOLE(type, type)
#define BEGIN(type)                  static const RecordedMember members_##type[] = {
#define MEMBER(type, member)         MEMBER_ROW(type, member)
#define END(type, definition)        };
#include "world/record/recorded_types.def"

#define TYPE_ROW(text, type, definition) \
	{text, (int)sizeof(type), members_##type, (int)(sizeof members_##type / sizeof *members_##type), definition},
const RecordedType recorded_types[RECORDED_TYPES] = {
#define PLAIN(type)                  TYPE_ROW(#type, type, NULL)
#define BEGIN(type)
#define MEMBER(type, member)
#define END(type, definition)        TYPE_ROW(#type, type, definition)
#include "world/record/recorded_types.def"
};
// clang-format on

size_t type_recorded_bytes(const RecordedType* type)
{
	size_t bytes = 0;
	for (int k = 0; k < type->count; ++k)
		bytes += (size_t)type->members[k].bytes;
	return bytes;
}

// ---------------------------------------------------------------------------------------------------------------
// calls
// ---------------------------------------------------------------------------------------------------------------

// index of the type of an argument, by its kind
#define VALUE_ID(type)   RECORDED_TYPE_##type
#define POINTER_ID(type) RECORDED_TYPE_##type
#define ARRAY_ID(type)   RECORDED_TYPE_##type
#define PATH_ID(type)    RECORDED_TYPE_##type
#define RESULT_ID(type)  RECORDED_TYPE_##type
#define RESULTS_ID(type) RECORDED_TYPE_##type
#define COUNT_ID(type)   -1
#define BYTES_ID(type)   -1
#define SIZE_ID(type)    -1

#define ROW_OF(kind, type, name)                \
	{                                           \
#name, ARGUMENT_##kind, kind##_ID(type) \
	}
#define ROW(k, argument) ROW_OF argument
#define ONE(k, argument) 1

// clang-format off
const RecordedCall recorded_calls[RECORDED_CALLS] = {
#define CALL(name, ...) {#name, (int)(sizeof((char[]){EACH(ONE, __VA_ARGS__)})), {EACH(ROW, __VA_ARGS__)}},
#include "world/record/recorded_calls.def"
};
// clang-format on
