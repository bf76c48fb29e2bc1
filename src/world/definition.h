// SPDX-License-Identifier: MIT
// definition.h -- reads definitions of programs that use another version of the header, and writes results for such
// programs. New versions add members at the end, with default 0. A definition contains its size; the size of a result is
// an argument of the function.
#ifndef DEFINITION_H
#define DEFINITION_H
#include "world/check.h"

typedef struct // a type of definition
{
	uint32_t bytes;               // size in this library, bytes
	uint32_t least;               // size in version 0.1.0, bytes
	const char* default_function; // name of the function that returns a definition with default values
} DefinitionType;

// Maximum size of definitions and results, bytes. A definition with a larger size was not initialized.
#define MOST_SIZE 4096

extern const DefinitionType world_definition, tuning_definition, attribute_definition, body_definition,
    collidable_definition, joint_definition, path_definition, query_definition, blast_definition, mover_definition,
    material_definition, field_definition, record_definition, draw_definition, surface_definition;

// Checks definition k of a batch. Its size must be that of the first, and members added by later versions must be 0.
scree_status check_definition(ArgumentPlace at, const void* defs, int k, const DefinitionType* type);

// Returns the address of definition k of a checked batch. If its size is not that of this library, copies it to
// `local`, sets missing members to 0, and returns the address of the copy.
const void* definition_at(const void* defs, int k, const DefinitionType* type, void* local);

// Copies the part of a result that fits into a struct of the caller, and clears the rest. bytes: size of the struct.
void write_result(void* to, size_t bytes, const void* result, size_t result_bytes);

#endif
