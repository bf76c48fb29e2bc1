// SPDX-License-Identifier: MIT
// field_wake.c -- wakes the bodies in the region of a field that the user changes.
#include "api/field/field_wake.h"
#include "platform/error.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include <math.h>

#define WAKE_MARGIN 0.01f // m: distance by which the box of a region is enlarged

static bool is_near(float x) { return fabsf(x) <= SCREE_MAX_COORDINATE; }

scree_status field_wake(scree_world* world, int index)
{
	const HostField* host = world->fields.host + index;
	const scree_shape* shape = &host->def.shape;
	scree_pose pose = host->def.pose;
	if (!world->def.sleep || host->def.disabled)
		return SCREE_OK;
	if (shape->count == 0)
		return api_world_set_awake(world, true);
	if (host->body >= 0)
	{
		scree_pose body;
		TRY(api_body_get_pose(world, body_handle(world, host->body), &body));
		pose = pose_product(body, pose);
	}
	scree_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
	float margin = shape->radius + WAKE_MARGIN;
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec corner = pose_point(pose, shape->vertices[k]);
		box.lower.x = fminf(box.lower.x, corner.x - margin);
		box.lower.y = fminf(box.lower.y, corner.y - margin);
		box.upper.x = fmaxf(box.upper.x, corner.x + margin);
		box.upper.y = fmaxf(box.upper.y, corner.y + margin);
	}
	// farther out there is no box that can be woken
	if (!is_near(box.lower.x) || !is_near(box.lower.y) || !is_near(box.upper.x) || !is_near(box.upper.y))
		return api_world_set_awake(world, true);
	return api_world_set_box_awake(world, box, true);
}
