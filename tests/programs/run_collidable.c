// SPDX-License-Identifier: MIT
// run_collidable.c -- makes the calls of collidables.
#include "programs/run_call.h"

static scree_status create(const CallRun* r)
{
	scree_collidable_def def = scree_collidable_def_default();
	scree_collidable made = {0, 0};
	def.attribute = call_attribute(r, "attribute");
	if (call_real(r, "body") >= 0.0f)
		def.body = call_body(r, call_whole(r, "body"));
	def.pose = call_pose(r);
	def.filter = call_filter(r);
	def.reports = (uint32_t)call_whole(r, "reports");
	def.sensor = (uint32_t)call_whole(r, "sensor");
	scree_status status = scree_collidable_create(r->world, &def, &made);
	int k = call_whole(r, "collidable");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->collidables[k] = made;
	return status;
}

static scree_status place(const CallRun* r)
{
	int k = call_whole(r, "collidable");
	scree_collidable collidable = k >= 0 && k < MOST_NAMES ? r->names->collidables[k] : (scree_collidable){0, 0};
	scree_pose pose = call_pose(r);
	return scree_collidables_set_poses(r->world, &collidable, &pose, 1);
}

scree_status run_collidable(const CallRun* r)
{
	switch (r->call->kind)
	{
	case CALL_collidable:
		return create(r);
	case CALL_remove:
		return scree_collidable_destroy(r->world, call_collidable(r));
	case CALL_filter:
		return scree_collidable_set_filter(r->world, call_collidable(r), call_filter(r));
	case CALL_reports:
		return scree_collidable_set_reports(r->world, call_collidable(r), (uint32_t)call_whole(r, "reports"));
	case CALL_sensor:
		return scree_collidable_set_sensor(r->world, call_collidable(r), (uint32_t)call_whole(r, "sensor"));
	case CALL_dress:
		return scree_collidable_set_attribute(r->world, call_collidable(r), call_attribute(r, "attribute"));
	default:
		return place(r);
	}
}
