// SPDX-License-Identifier: MIT
// moved_bodies.h -- lists the bodies that moved, fell asleep or woke since the last report to the user. No step reads
// this list.
//
// The poses are those of origins, so a new center of mass or rounding error (pool pose_low) does not count as a motion.
#ifndef MOVED_BODIES_H
#define MOVED_BODIES_H
#include "dialect/vec.h"
#include "pools/pools.h"
#include "stages/edit/asleep.h"

KERNEL(moved_begin)
{
	p->counters->moved_bodies = 0;
	(void)i;
}

// Returns the pose of a body's origin, with the same rounding as world_body_pose.
INLINE Float4 reported_origin(const Pools* p, int i)
{
	Float4 pose = p->pose[i];
	Float2 center = p->local_center[i];
	Vec shift = vec_turn(vec(pose.z, pose.w), vec(center.x, center.y));
	return make_float4(pose.x - shift.x, pose.y - shift.y, pose.z, pose.w);
}

// Lists body i if it moved, fell asleep or woke. A new body is always listed: its reported pose is 0, which is no valid
// rotation.
LIST_KERNEL(moved_mark, moved_bodies, moved_bodies)
{
	Float4 now = reported_origin(p, i), then = p->reported_pose[i];
	int moved = now.x != then.x || now.y != then.y || now.z != then.z || now.w != then.w ||
	            body_sleeps_on(p, i) != p->reported_sleep[i];
	return moved ? i : -1;
}

KERNEL(moved_key) { p->key[i] = (Word64)p->moved_bodies[i]; }

// Writes the rows of moved bodies, after the sort.
KERNEL(moved_list)
{
	MovedBody row;
	int body = (int)p->key[i], asleep = body_sleeps_on(p, body);
	row.body = body + (asleep ? MOVED_ASLEEP : 0);
	row.pose = p->pose[body];
	row.vx = p->body[body].vx;
	row.vy = p->body[body].vy;
	row.w = p->body[body].w;
	StoredVelocity stored = p->stored_velocity[body];
	if (stored.stored != 0.0f) // a disabled body: reports the stored velocity
	{
		row.vx = stored.vx;
		row.vy = stored.vy;
		row.w = stored.w;
	}
	p->reported_pose[body] = reported_origin(p, body);
	p->reported_sleep[body] = asleep;
	p->moved_row[i] = row;
}

#endif
