// SPDX-License-Identifier: MIT
// finalize.h -- the step's motion into the poses; bodies whose state is not finite are frozen and counted.
#ifndef FINALIZE_H
#define FINALIZE_H
#include "stages/body.h"

// m: the edge of the world. Every product of two lengths within it is finite.
#define FINALIZE_EDGE 1.0e8f

// false for NaN too
INLINE int finalize_finite(float x) { return x >= -3.4e38f && x <= 3.4e38f; }

STAGE(finalize)
{
	GLOBAL BodyState* body = p->body + i;
	Motion motion = p->motion[i];
	Float4 pose = p->pose[i];
	float vx = motion.free_x * body->vx, vy = motion.free_y * body->vy, w = body->w;
	float x = pose.x + body->dx, y = pose.y + body->dy, da = body->da;
	if (!(finalize_finite(x) && finalize_finite(y) && finalize_finite(da) && finalize_finite(vx) &&
	      finalize_finite(vy) && finalize_finite(w)))
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

	// impulses of the last substep may have exceeded the limits
	Vec scale = body_speed_scale(&p->step, vec(vx, vy));
	x = limit_to(x, FINALIZE_EDGE);
	y = limit_to(y, FINALIZE_EDGE);
	vx = scale.y * (scale.x * vx);
	vy = scale.y * (scale.x * vy);
	w = limit_to(w, p->step.max_spin);
	if (da != 0.0f)
	{
		Vec q = vec_turn(vec_rotation(da), vec(pose.z, pose.w));
		float unit = 1.0f / square_root(vec_dot(q, q));
		pose.z = unit * q.x;
		pose.w = unit * q.y;
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
