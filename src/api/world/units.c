// SPDX-License-Identifier: MIT
// units.c -- lists the constants with a length, and returns the unit of length of a world.
#include "platform/processor.h"
#include "world/check.h"
#include "world/definition.h"
#include "world/record/api_calls.h"
#include "world/world.h"

static const scree_constant constants[] = {
#define CONSTANT(name, value, power, unit, meaning) {#name, value, power, unit, meaning},
#include "world/units/constants.def"
};
#define CONSTANTS (int)(sizeof constants / sizeof *constants)

scree_status api_units_sized(scree_constant* list, size_t size, int capacity, int* count)
{
	TRY(check_list("scree_units", "constants", list, capacity, count));
	*count = CONSTANTS;
	for (int k = 0; k < CONSTANTS && k < capacity; ++k)
		write_result((char*)list + (size_t)k * size, size, constants + k, sizeof *constants);
	return SCREE_OK;
}

float scree_world_get_length_unit(const scree_world* world)
{
	if (!world)
		return 0.0f;
	return world->def.length_unit != 0.0f ? world->def.length_unit : 1.0f;
}
