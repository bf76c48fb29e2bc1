// SPDX-License-Identifier: MIT
// upload_rows.h -- writes long runs of rows, pool by pool.
#ifndef UPLOAD_ROWS_H
#define UPLOAD_ROWS_H
#include "world/world.h"

// Write rows begin to end, one run, or all attributes that wait, by runs of neighboring slots. stage has room for the longest
// item of each row. An attribute that was destroyed again is written as it was.
scree_status upload_bodies(scree_world* world, int begin, int end, char* stage);
scree_status upload_collidables(scree_world* world, int begin, int end, char* stage);
scree_status upload_attributes(scree_world* world, char* stage);

static inline Filter filter_row(scree_filter filter)
{
	return (Filter){.category = filter.category, .mask = filter.mask, .group = filter.group};
}

static inline Float4 pose_row(scree_pose pose)
{
	return make_float4(pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s);
}

#endif
