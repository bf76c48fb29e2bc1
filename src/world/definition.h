// SPDX-License-Identifier: MIT
// definition.h -- reads definitions of programs built with another version of the header, and writes results for them.
// New versions add members at the end, with default 0. Definitions contain their size; for results it is an argument.
#ifndef DEFINITION_H
#define DEFINITION_H
#include "world/check.h"

typedef struct // a type of definition
{
	uint32_t bytes;               // bytes: size in this library
	uint32_t least;               // bytes: size in version 0.1.0
	const char* default_function; // name of the function that returns a definition with default values
} DefinitionType;

// bytes: upper bound of the sizes of definitions and results. A definition with a larger size was not initialized.
#define MOST_SIZE 4096

extern const DefinitionType world_definition, tuning_definition, attribute_definition, body_definition,
    collidable_definition, joint_definition, path_definition, query_definition, blast_definition, mover_definition,
    material_definition, field_definition;

// Checks definition k of a batch. All definitions of a batch must have the size of the first.
scree_status check_definition(ArgumentPlace at, const void* defs, int k, const DefinitionType* type);

// Returns the address of definition k of a checked batch. If its size is not that of this library, copies it to
// `local`, and returns the address of the copy.
const void* definition_at(const void* defs, int k, const DefinitionType* type, void* local);

// Copies a result into a struct of the caller. bytes: size of the struct; its bytes beyond the result become 0.
void write_result(void* to, size_t bytes, const void* result, size_t result_bytes);

#endif
