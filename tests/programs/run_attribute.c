// SPDX-License-Identifier: MIT
// run_attribute.c -- makes the calls of attributes, and their shapes.
#include "programs/run_call.h"

static scree_status make_polygon(const CallRun* r, scree_shape* shape)
{
	scree_vec corners[16];
	int count = call_whole(r, "corners");
	count = count < 0 ? 0 : count > 16 ? 16 : count;
	for (int k = 0; k < count; ++k)
	{
		scree_rot q = scree_rot_make(call_real(r, "angle") + 6.28318531f * (float)k / (float)count);
		corners[k] = (scree_vec){0.5f * call_real(r, "width") * q.c, 0.5f * call_real(r, "height") * q.s};
	}
	return scree_shape_make_polygon(corners, count, call_real(r, "radius"), shape);
}

static scree_status make_hull(const CallRun* r, scree_shape* shape)
{
	scree_vec points[64];
	int count = call_whole(r, "points");
	count = count < 0 ? 0 : count > 64 ? 64 : count;
	uint32_t seed = (uint32_t)call_whole(r, "seed") + 1u;
	for (int k = 0; k < count; ++k)
	{
		float two[2];
		for (int i = 0; i < 2; ++i)
		{
			two[i] = call_real(r, "size") * ((float)(call_random(&seed) >> 16) / 65536.0f - 0.5f);
		}
		points[k] = (scree_vec){two[0], two[1]};
	}
	return scree_shape_make_hull(points, count, call_real(r, "radius"), shape);
}

static scree_status make_shape(const CallRun* r, scree_shape* shape)
{
	switch (r->call->kind)
	{
	case CALL_box:
		return scree_shape_make_box(0.5f * call_real(r, "width"), 0.5f * call_real(r, "height"), shape);
	case CALL_circle:
		return scree_shape_make_circle(call_vec(r, "x", "y"), call_real(r, "radius"), shape);
	case CALL_capsule:
		return scree_shape_make_capsule(call_vec(r, "x", "y"), call_vec(r, "x2", "y2"), call_real(r, "radius"), shape);
	case CALL_segment:
		return scree_shape_make_segment(call_vec(r, "x", "y"), call_vec(r, "x2", "y2"), shape);
	case CALL_polygon:
		return make_polygon(r, shape);
	case CALL_like:
	{
		scree_attribute_def def = scree_attribute_def_default();
		scree_status status = scree_attribute_get_def(r->world, call_attribute(r, "of"), &def);
		*shape = def.shape;
		return status;
	}
	default:
		return make_hull(r, shape);
	}
}

scree_status run_attribute(const CallRun* r)
{
	if (r->call->kind == CALL_drop)
		return scree_attribute_destroy(r->world, call_attribute(r, "attribute"));
	scree_shape shape = {0};
	scree_attribute made = {0, 0};
	scree_status status = make_shape(r, &shape);
	scree_attribute_def def = call_surface(r, shape);
	if (status == SCREE_OK)
		status = scree_attribute_create(r->world, &def, &made);
	int k = call_whole(r, "attribute");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->attributes[k] = made;
	return status;
}
