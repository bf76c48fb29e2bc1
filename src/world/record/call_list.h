// SPDX-License-Identifier: MIT
// call_list.h -- describes the recorded calls: names, arguments, and the members of structs.
#ifndef CALL_LIST_H
#define CALL_LIST_H
#include "world/definition.h"
#include "world/record/api_calls.h"
#include <stdbool.h>

typedef enum // kinds of recorded_calls.def; a file contains these numbers
{
	ARGUMENT_VALUE,
	ARGUMENT_POINTER,
	ARGUMENT_ARRAY,
	ARGUMENT_COUNT,
	ARGUMENT_PATH,
	ARGUMENT_BYTES,
	ARGUMENT_SIZE,
	ARGUMENT_RESULT,
	ARGUMENT_RESULTS,
	ARGUMENT_KINDS
} ArgumentKind;

typedef struct // a member of a struct, or the whole of a plain type
{
	const char* name;
	int offset, bytes; // offset -1: the library lacks this member of a file
	bool truth;        // a bool, 0 or 1
} RecordedMember;

typedef struct // a type of arguments
{
	const char* name;
	int bytes; // size of the type in C
	const RecordedMember* members;
	int count;
	const DefinitionType* definition; // null for a type that does not begin with its size
} RecordedType;

typedef struct
{
	const char* name;
	ArgumentKind kind;
	int type; // index of recorded_types; -1 for the kinds COUNT, BYTES and SIZE
} RecordedArgument;

typedef struct
{
	const char* name; // without "scree_"
	int count;        // number of arguments
	RecordedArgument arguments[MOST_RECORDED_ARGUMENTS];
} RecordedCall;

typedef enum
{
#define CALL(name, ...) RECORDED_##name,
#include "world/record/recorded_calls.def"
	RECORDED_CALLS
} RecordedCallId;

typedef enum
{
#define TYPE_ENUMERATOR(type) RECORDED_TYPE_##type,
#define PLAIN(type)           TYPE_ENUMERATOR(type)
#define BEGIN(type)           TYPE_ENUMERATOR(type)
#define MEMBER(type, member)
#define END(type, definition)
#include "world/record/recorded_types.def"
	RECORDED_TYPES
} RecordedTypeId;

extern const RecordedCall recorded_calls[RECORDED_CALLS];
extern const RecordedType recorded_types[RECORDED_TYPES];

// Returns the number of bytes of an item in a recording: the sum of those of its members.
size_t type_recorded_bytes(const RecordedType* type);

#endif
