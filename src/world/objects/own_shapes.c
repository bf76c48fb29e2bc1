// SPDX-License-Identifier: MIT
// own_shapes.c -- makes the attributes of a batch of collidables that own their shapes.
#include "world/objects/own_shapes.h"
#include "world/objects/attribute_check.h"
#include "world/objects/attributes.h"

scree_status own_shapes_check(const char* function, const char* argument, const scree_attribute_def* shapes, int count,
                              bool alone)
{
	TRY(check_batch(function, argument, shapes, count));
	scree_attribute_def plain;
	for (int k = 0; k < count; ++k)
		TRY(attribute_check((ArgumentPlace){function, argument, alone ? ALONE : k}, shapes, k, &plain));
	return SCREE_OK;
}

scree_status own_shapes_make(scree_world* world, const char* function, const scree_attribute_def* shapes, int count,
                             int* attributes)
{
	scree_attribute_def plain;
	scree_status status = SCREE_OK;
	int made = 0;
	while (made < count && status == SCREE_OK)
	{
		status = attribute_check((ArgumentPlace){function, "shapes", made}, shapes, made, &plain);
		if (status == SCREE_OK)
			status = attribute_own(world, function, &plain, attributes + made);
		made += status == SCREE_OK;
	}
	if (status != SCREE_OK)
		own_shapes_settle(world, attributes, made);
	return status;
}

void own_shapes_settle(scree_world* world, const int* attributes, int count)
{
	for (int k = 0; k < count; ++k)
		attribute_settle(world, attributes[k]);
}
