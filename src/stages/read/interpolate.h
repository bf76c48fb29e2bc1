// SPDX-License-Identifier: MIT
// interpolate.h -- computes poses of bodies between those before and after the last step, for drawing. No step reads them.
//
// A body turns by the angle between both rotations at constant speed, so its angular velocity is even. A blend of the
// two rotations would turn faster in the middle, and a fast wheel would shrink to a point.
#ifndef INTERPOLATE_H
#define INTERPOLATE_H
#include "constraints/angle.h"
#include "dialect/finite.h"
#include "pools/pools.h"

#define INTERPOLATE_HALF 3.0f // rad: a body that turns by more may have turned by half a turn, in either direction
#define INTERPOLATE_TURN 6.28318531f

// Returns the angle by which body i turned in the last step. After about half a turn, its direction is that of the motion
// that the step stored.
INLINE float interpolate_angle(const Pools* p, int i, Vec then, Vec now)
{
	float angle = vec_angle(vec_turn_back(then, now)), motion = p->body[i].da;
	if (angle > INTERPOLATE_HALF && motion < 0.0f)
		return angle - INTERPOLATE_TURN;
	return angle < -INTERPOLATE_HALF && motion > 0.0f ? angle + INTERPOLATE_TURN : angle;
}

// Writes a pose of the center of mass of body i. The argument has the bits of the fraction of the step, from 0 to 1.
// Tiny products are flushed, because devices differ in denormals.
KERNEL(interpolate)
{
	float alpha = bits_float(p->argument);
	Float4 then = p->start_pose[i], now = p->pose[i];
	int stands = then.z == 0.0f && then.w == 0.0f;
	p->base[i] = stands || alpha == 1.0f ? now : then;
	if (stands || alpha == 0.0f || alpha == 1.0f)
		return;
	Vec turn = vec(then.z, then.w);
	float angle = flush_tiny(alpha * interpolate_angle(p, i, turn, vec(now.z, now.w)));
	if (angle != 0.0f)
	{
		turn = vec_turn(vec_rotation(angle), turn);
		turn = vec_scale(unit_factor(vec_dot(turn, turn)), turn);
	}
	Vec d = vec_flush_tiny(vec(alpha * (now.x - then.x), alpha * (now.y - then.y)));
	p->base[i] = make_float4(then.x + d.x, then.y + d.y, turn.x, turn.y);
}

#endif
