// SPDX-License-Identifier: MIT
// attribute.c -- creates one attribute for equal definitions, and destroys it after as many destructions as creations.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/attribute_check.h"
#include "world/objects/attributes.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"
#include "world/world.h"

void scree_attribute_def_default_sized(scree_attribute_def* def, size_t size)
{
	scree_attribute_def made = {.size = (uint32_t)size, .density = 1.0f, .friction = DEFAULT_FRICTION};
	scree_shape_make_box(0.5f, 0.5f, &made.shape);
	write_result(def, size, &made, sizeof made);
}

scree_status api_attribute_create(scree_world* world, const scree_attribute_def* def, scree_attribute* attribute)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_attribute_create";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "def", def));
	TRY(check_pointer(function, "attribute", attribute));
	scree_attribute_def plain;
	TRY(attribute_check((ArgumentPlace){function, "def", ALONE}, def, 0, &plain));
	int index = 0;
	TRY(attribute_claim(world, function, &plain, &index));
	*attribute = attribute_handle(world, index);
	return SCREE_OK;
}

scree_status api_world_get_attributes(const scree_world* world, scree_attribute* attributes, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_attributes";
	int listed = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_list(function, "attributes", attributes, capacity, count));
	for (int k = 0; k < world->attribute_slots.used; ++k)
	{
		if (!slots_in_use(&world->attribute_slots, k))
			continue;
		if (listed < capacity)
			attributes[listed] = attribute_handle(world, k);
		++listed;
	}
	*count = listed;
	return SCREE_OK;
}

scree_status api_attribute_get_def_sized(const scree_world* world, scree_attribute attribute, scree_attribute_def* def,
                                         size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_attribute_get_def";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "def", def));
	int index = 0;
	TRY(check_attribute(world, (ArgumentPlace){function, "attribute", ALONE}, "", attribute, &index));
	scree_attribute_def known = world->attributes[index];
	known.size = (uint32_t)size;
	write_result(def, size, &known, sizeof known);
	return SCREE_OK;
}

scree_status api_attribute_destroy(scree_world* world, scree_attribute attribute)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_attribute_destroy";
	TRY(world_check(world, function));
	int index = 0;
	ArgumentPlace at = {function, "attribute", ALONE};
	TRY(check_attribute(world, at, "", attribute, &index));
	const HostAttribute* host = world->host_attributes + index;
	if (host->claims == 0)
		return refuse(
		    SCREE_ERROR_INVALID, at, "",
		    "(index %u) was not made by scree_attribute_create: it ends with the last collidable that uses it",
		    attribute.index);
	if (host->claims == 1 && host->collidables > 0)
		return refuse(SCREE_ERROR_INVALID, at, "", "(index %u) is still used by %d collidable%s", attribute.index,
		              host->collidables, host->collidables == 1 ? "" : "s");
	attribute_disclaim(world, index);
	return SCREE_OK;
}

bool scree_attribute_is_valid(const scree_world* world, scree_attribute attribute)
{
	return world && attribute_is_valid(world, attribute);
}
