// SPDX-License-Identifier: MIT
// finalize.h -- the step's motion into the poses; bodies whose state is not finite are frozen and counted.
#ifndef FINALIZE_H
#define FINALIZE_H
#include "stages/body.h"

// false for NaN too
INLINE int finalize_bounded(float x, float limit) { return x >= -limit && x <= limit; }

STAGE(finalize)
{
	GLOBAL BodyState* body = p->body + i;
	Motion motion = p->motion[i];
	Float4 pose = p->pose[i];
	float vx = motion.free_x * body->vx, vy = motion.free_y * body->vy, w = body->w;
	float x = pose.x + body->dx, y = pose.y + body->dy, da = body->da;

	// the largest float is 3.4e38; a hundred million metres is as good as lost, and keeps every later product finite
	float far = 1.0e8f;
	if (!(finalize_bounded(x, far) && finalize_bounded(y, far) && finalize_bounded(da, 4.0f) &&
	      finalize_bounded(vx, far) && finalize_bounded(vy, far) && finalize_bounded(w, far)))
	{
		atomic_add_int(&p->counters->nonfinite, 1);
		atomic_min_int(&p->counters->first_nonfinite, i);
		x = pose.x;
		y = pose.y;
		da = 0.0f;
		vx = 0.0f;
		vy = 0.0f;
		w = 0.0f;
		body->dx = 0.0f;
		body->dy = 0.0f;
		body->da = 0.0f;
	}
	if (da != 0.0f)
	{
		Vec q = vec_turn(vec_rotation(da), vec(pose.z, pose.w));
		float scale = 1.0f / square_root(vec_dot(q, q));
		pose.z = scale * q.x;
		pose.w = scale * q.y;
	}
	p->pose[i] = make_float4(x, y, pose.z, pose.w);
	body->vx = vx;
	body->vy = vy;
	body->w = w;
	if (float_bits(motion.fx) | float_bits(motion.fy) | float_bits(motion.torque))
	{
		p->motion[i].fx = 0.0f;
		p->motion[i].fy = 0.0f;
		p->motion[i].torque = 0.0f;
	}
}

#endif
