// SPDX-License-Identifier: MIT
// definition.c -- reads definitions of programs that use another version of the header, and writes results for them.
#include "world/definition.h"
#include <stddef.h>
#include <string.h>

// end of a member, in bytes from the start of its struct
#define END_OF(type, member) (uint32_t)(offsetof(type, member) + sizeof((type*)0)->member)

const DefinitionType world_definition = {sizeof(scree_world_def), END_OF(scree_world_def, contact_limit),
                                         "scree_world_def_default"};
const DefinitionType tuning_definition = {sizeof(scree_tuning), END_OF(scree_tuning, max_speed),
                                          "scree_world_get_tuning"};
const DefinitionType attribute_definition = {sizeof(scree_attribute_def), END_OF(scree_attribute_def, tangent_speed),
                                             "scree_attribute_def_default"};
const DefinitionType surface_definition = {sizeof(scree_surface), END_OF(scree_surface, tangent_speed),
                                           "scree_surface_default"};
const DefinitionType body_definition = {sizeof(scree_body_def), END_OF(scree_body_def, user), "scree_body_def_default"};
const DefinitionType collidable_definition = {sizeof(scree_collidable_def), END_OF(scree_collidable_def, user),
                                              "scree_collidable_def_default"};
const DefinitionType joint_definition = {sizeof(scree_joint_def), END_OF(scree_joint_def, user),
                                         "scree_joint_def_make"};
const DefinitionType path_definition = {sizeof(scree_path_def), END_OF(scree_path_def, user), "scree_path_def_default"};
const DefinitionType query_definition = {sizeof(scree_query_def), END_OF(scree_query_def, one_way),
                                         "scree_query_def_default"};
const DefinitionType blast_definition = {sizeof(scree_blast_def), END_OF(scree_blast_def, mask),
                                         "scree_blast_def_default"};
const DefinitionType mover_definition = {sizeof(scree_mover_def), END_OF(scree_mover_def, mask),
                                         "scree_mover_def_default"};
const DefinitionType material_definition = {sizeof(scree_material_pair), END_OF(scree_material_pair, tangent_speed),
                                            "scree_material_pair_default"};
const DefinitionType field_definition = {sizeof(scree_field_def), END_OF(scree_field_def, user),
                                         "scree_field_def_default"};
const DefinitionType record_definition = {sizeof(scree_record_def), END_OF(scree_record_def, hash_interval),
                                          "scree_record_def_default"};
const DefinitionType draw_definition = {sizeof(scree_draw_def), END_OF(scree_draw_def, text), "scree_draw_def_default"};

static uint32_t size_of(const void* def)
{
	uint32_t size;
	memcpy(&size, def, sizeof size);
	return size;
}

static const char* place_of(const void* defs, int k) { return (const char*)defs + (size_t)k * size_of(defs); }

scree_status check_definition(ArgumentPlace at, const void* defs, int k, const DefinitionType* type)
{
	const char* def = place_of(defs, k);
	uint32_t size = size_of(def);
	if (size < type->least || size > MOST_SIZE)
		return refuse(SCREE_ERROR_INVALID, at, ".size", "is %u: the definition was not made by %s", size,
		              type->default_function);
	if (size != size_of(defs))
		return refuse(SCREE_ERROR_INVALID, at, ".size", "is %u, and that of the first is %u", size, size_of(defs));
	for (uint32_t i = type->bytes; i < size; ++i)
	{
		if (def[i] != 0)
			return refuse(SCREE_ERROR_INVALID, at, "",
			              "sets a member at byte %u, which version %s of the library lacks", i, scree_version());
	}
	return SCREE_OK;
}

const void* definition_at(const void* defs, int k, const DefinitionType* type, void* local)
{
	uint32_t size = size_of(defs);
	const char* def = place_of(defs, k);
	if (size == type->bytes)
		return def;
	memset(local, 0, type->bytes);
	memcpy(local, def, size < type->bytes ? size : type->bytes);
	memcpy(local, &type->bytes, sizeof type->bytes);
	return local;
}

void write_result(void* to, size_t bytes, const void* result, size_t result_bytes)
{
	size_t known = bytes < result_bytes ? bytes : result_bytes;
	memcpy(to, result, known);
	memset((char*)to + known, 0, bytes - known);
}
