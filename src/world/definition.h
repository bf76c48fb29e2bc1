// SPDX-License-Identifier: MIT
// definition.h -- definitions and results of programs that were built with another version of the header.
//
// Such structs only ever grow, at their end, by members whose default is 0. A definition says its size, and a function
// that fills a result is told it.
#ifndef DEFINITION_H
#define DEFINITION_H
#include "world/attributes.h" // these, but for check.h, are for src/api/contacts.c, which includes only this header and world.h
#include "world/check.h"
#include "world/failure.h"
#include "world/handles.h"
#include "world/memory.h"
#include "world/read.h"
#include "world/upload.h"

typedef struct // of one type of definition
{
	uint32_t bytes;               // here
	uint32_t least;               // in version 0.1.0
	const char* default_function; // fills one with defaults
} DefinitionType;

extern const DefinitionType world_definition, tuning_definition, attribute_definition, body_definition,
    collidable_definition;

// Definition k of a batch, all of which have the size of the first.
scree_status check_definition(Where at, const void* defs, int k, const DefinitionType* type);

// The same once it is checked: where it lies, if it has this library's size, else as a copy in local, a struct of the
// type.
const void* definition_at(const void* defs, int k, const DefinitionType* type, void* local);

// A result of this library into a struct of so many bytes; those that it does not know become 0.
void write_result(void* to, size_t bytes, const void* result, size_t result_bytes);

#endif
