// SPDX-License-Identifier: MIT
// moved_bodies.h -- bodies at other poses than the user was told last, on request. No step reads or writes this.
//
// Poses are those of origins, as the user reads them, and compared as numbers: another center of mass, and the rounding error of a pose,
// move no body.
#ifndef MOVED_BODIES_H
#define MOVED_BODIES_H
#include "dialect/vec.h"
#include "pools/pools.h"

STAGE(told_begin)
{
	p->counters->told = 0;
	(void)i;
}

// The pose of a body's origin, with the roundings of world_body_pose.
INLINE Float4 told_origin(const Pools* p, int i)
{
	Float4 pose = p->pose[i];
	Float2 center = p->local_center[i];
	Vec shift = vec_turn(vec(pose.z, pose.w), vec(center.x, center.y));
	return make_float4(pose.x - shift.x, pose.y - shift.y, pose.z, pose.w);
}

// A new row has the pose 0, whose rotation no body has.
LIST_STAGE(told_mark, told, told)
{
	Float4 now = told_origin(p, i), then = p->told_pose[i];
	return now.x != then.x || now.y != then.y || now.z != then.z || now.w != then.w;
}

STAGE(told_key) { p->key[i] = (Word64)p->told[i]; }

// After the sort.
STAGE(told_list)
{
	Told row;
	row.body = (int)p->key[i];
	row.pose = p->pose[row.body];
	row.vx = p->body[row.body].vx;
	row.vy = p->body[row.body].vy;
	row.w = p->body[row.body].w;
	StoredVelocity stored = p->stored_velocity[row.body];
	if (stored.stored != 0.0f) // of a disabled body
	{
		row.vx = stored.vx;
		row.vy = stored.vy;
		row.w = stored.w;
	}
	p->told_pose[row.body] = told_origin(p, row.body);
	p->told_row[i] = row;
}

#endif
