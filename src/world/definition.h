// SPDX-License-Identifier: MIT
// definition.h -- reads definitions and writes results of programs that were built with another version of the header.
//
// New versions add members at the end, with 0 as their default. A definition stores its size; for a result, the size is
// an argument of the call.
#ifndef DEFINITION_H
#define DEFINITION_H
#include "world/check.h"

typedef struct // a type of definition
{
	uint32_t bytes;               // bytes: size in this library
	uint32_t least;               // bytes: size in version 0.1.0
	const char* default_function; // name of the function that returns a definition with default values
} DefinitionType;

// Upper bound of the sizes of definitions and results, bytes. A definition with a larger size was not initialized by
// its caller.
#define MOST_SIZE 4096

extern const DefinitionType world_definition, tuning_definition, attribute_definition, body_definition,
    collidable_definition, joint_definition, path_definition, query_definition, blast_definition, mover_definition,
    material_definition, field_definition;

// Checks definition k of a batch. All definitions of a batch must have the size of the first.
scree_status check_definition(ArgumentPlace at, const void* defs, int k, const DefinitionType* type);

// Returns definition k of a checked batch: its address if it has the size of this library, else the address local, with
// a copy.
const void* definition_at(const void* defs, int k, const DefinitionType* type, void* local);

// Copies a result of this library into a struct of the caller. bytes: size of this struct; bytes beyond the result
// become 0.
void write_result(void* to, size_t bytes, const void* result, size_t result_bytes);

#endif
