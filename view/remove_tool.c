// SPDX-License-Identifier: MIT
// remove_tool.c -- removes a body at the wish of the user.
#include "view/remove_tool.h"

bool remove_body(scree_world* world, scree_body body, const char** reason)
{
	scree_body_type type;
	int joints = 0;
	*reason = NULL;
	if (scree_body_get_type(world, body, &type) != SCREE_OK ||
	    scree_body_get_joints(world, body, NULL, 0, &joints) != SCREE_OK)
		return false;
	if (type != SCREE_BODY_DYNAMIC || joints > 0)
	{
		*reason = joints > 0 ? "a body with joints cannot be removed" : "only dynamic bodies can be removed";
		return false;
	}
	return scree_body_destroy(world, body) == SCREE_OK;
}
