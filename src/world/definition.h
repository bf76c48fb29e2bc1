// SPDX-License-Identifier: MIT
// definition.h -- definitions and results of programs that were built with another version of the header.
//
// New versions add members at the end; their default is 0. A definition stores its size, a result gets it as argument.
#ifndef DEFINITION_H
#define DEFINITION_H
#include "world/check.h"

typedef struct // a type of definition
{
	uint32_t bytes;               // size in this library
	uint32_t least;               // size in version 0.1.0
	const char* default_function; // name of the function that fills one with defaults
} DefinitionType;

// Upper bound of the size of all definitions and results, bytes. A larger size means that the caller did not set it.
#define MOST_SIZE 4096

extern const DefinitionType world_definition, tuning_definition, attribute_definition, body_definition,
    collidable_definition, joint_definition, path_definition, query_definition, blast_definition, mover_definition,
    material_definition, field_definition;

// Checks definition k of a batch. All definitions of a batch have the size of the first.
scree_status check_definition(ArgumentPlace at, const void* defs, int k, const DefinitionType* type);

// Returns definition k of a checked batch: its address if it has this library's size, else a copy in local.
const void* definition_at(const void* defs, int k, const DefinitionType* type, void* local);

// Copies a result of this library into a struct of the given size; bytes beyond the result become 0.
void write_result(void* to, size_t bytes, const void* result, size_t result_bytes);

#endif
