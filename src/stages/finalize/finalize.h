// SPDX-License-Identifier: MIT
// finalize.h -- adds the step's motion to the poses; freezes and counts bodies whose state is not finite.
#ifndef FINALIZE_H
#define FINALIZE_H
#include "stages/edit/active.h"
#include "stages/finalize/continuous.h"
#include "stages/geometry/pose.h"
#include "stages/solve/press.h"

// Returns whether all values are finite: 0 times a value that is not finite is NaN.
INLINE int finalize_finite(Vec v, float w, Vec d, float da)
{
	return 0.0f * v.x + 0.0f * v.y + 0.0f * w + 0.0f * d.x + 0.0f * d.y + 0.0f * da == 0.0f;
}

INLINE void finalize_pose(const Pools* p, int i, Vec d, float da)
{
	p->start_pose[i] = p->pose[i];
	Vec turn = vec(p->pose[i].z, p->pose[i].w);
	if (da != 0.0f)
	{
		turn = vec_turn(vec_rotation(da), turn);
		turn = vec_scale(unit_factor(vec_dot(turn, turn)), turn);
	}
	pose_move(p, i, d, turn);
}

// Limits speed, spin and displacement of a body that is or was recently pressed between two others. The maximum speed
// is the larger of the press's speed and the body's speed before the step (times PRESS_SLOWER while it is pressed),
// plus the speed that gravity adds. Returns whether the body may get too deep into something static.
INLINE int finalize_pressed(const Pools* p, int i, Vec* v, float* w, Vec* d, float da)
{
	Press press = p->press[i];
	if ((press.way[1] | press.left | press.speed | press.depth) == 0)
		return 0;
	int between = press.way[0] != 0 && press.way[1] != 0;
	int left = between ? PRESS_STEPS : press.left - (press.left > 0 && !press.tight);
	if (left > 0)
	{
		float fall = p->step.dt * (absolute(gravity_x_of(p, i)) + absolute(gravity_y_of(p, i)));
		float most = maximum(bits_float(press.speed), (between ? PRESS_SLOWER : 1.0f) * press.before) + fall;
		float spin = maximum(press.spun, quotient(most, maximum(p->continuous_body[i].reach, LINEAR_SLOP)));
		*v = vec_limit(*v, most);
		*w = within(*w, spin);
		*d = vec_flush_tiny(vec_limit(*d, p->step.dt * maximum(most, p->step.push_speed)));
		raise_int(&p->counters->ways, 1);
		if (BATCHED(p))
			raise_int(&bay_state_of(p, i)->ways, 1);
		p->press[i].left = left;
	}
	else if (press.left != 0 || press.speed != 0)
	{
		p->press[i].left = 0;
		p->press[i].speed = 0;
	}
	return press.depth != 0 && continuous_presses(p, i, bits_float(press.depth), *d, da);
}

// Counts the time for which an awake body has been at rest: no point has moved faster than the threshold. d, da: motion
// in the step. The motion, not the velocity, is compared, because soft contacts make bodies at rest breathe. dynamic: 0
// for a kinematic body that moves.
INLINE void finalize_awake(const Pools* p, int i, int dynamic, Vec d, float da)
{
	if (p->stored_velocity[i].stored != 0.0f)
		return;
	raise_int(&p->counters->movers, 1);
	float own = p->sleep_threshold[i], general = bay_sleep_threshold(p, i), still = maximum(p->still[i], 0.0f);
	if (!dynamic || general < 0.0f)
		return;
	float most = p->step.dt * (own > 0.0f ? own : general);
	float far = absolute(d.x) + absolute(d.y) + absolute(da) * p->continuous_body[i].reach;
	still = far <= most ? still + p->step.dt : 0.0f;
	p->still[i] = still;
	if (still >= SLEEP_TIME && own >= 0.0f)
	{
		raise_int(&p->counters->drowsy, 1);
		if (BATCHED(p))
			raise_int(&bay_state_of(p, i)->drowsy, 1);
	}
}

INLINE void finalize_body(const Pools* p, int i)
{
	GLOBAL BodyState* body = p->body + i;
	Motion motion = p->motion[i];
	Vec v = vec(motion.free_x * body->vx, motion.free_y * body->vy), d = vec(body->dx, body->dy);
	float w = body->w, da = body->da;
	if (!finalize_finite(v, w, d, da))
	{
		atomic_add_int(&p->counters->nonfinite, 1);
		atomic_min_int(&p->counters->first_nonfinite, i);
		if (BATCHED(p))
			atomic_add_int(&bay_state_of(p, i)->nonfinite, 1);
		v = vec(0.0f, 0.0f);
		d = vec(0.0f, 0.0f);
		w = 0.0f;
		da = 0.0f;
		body->dx = 0.0f;
		body->dy = 0.0f;
		body->da = 0.0f;
	}
	if (p->step.sleep && (body->inv_mass > 0.0f ? p->sleep[i] == 0 : v.x != 0.0f || v.y != 0.0f || w != 0.0f))
		finalize_awake(p, i, body->inv_mass > 0.0f, d, da);
	int forced = (float_bits(motion.fx) | float_bits(motion.fy) | float_bits(motion.torque)) != 0, pressed = 0;
	if (p->counters->presses != 0 && body->inv_mass > 0.0f && !press_rests(p, bay_state_of(p, i)))
	{
		pressed = finalize_pressed(p, i, &v, &w, &d, da);
		body->dx = d.x;
		body->dy = d.y;
	}
	if (pressed)
		p->continuous_list[atomic_add_int(&p->counters->continuous_items, 1)] = make_int2(i, -1);
	else if (body->inv_mass > 0.0f && continuous_wanted(p, i, d, da) &&
	         (forced || !continuous_foreseen(p, i, motion.gravity_scale)) && !continuous_clear(p, i, d, da))
		continuous_enlist(p, i);
	else
		finalize_pose(p, i, d, da);

	// impulses of the last substep may have raised the velocity above its limits
	v = vec_flush_tiny(sweep_velocity(&p->step, v));
	body->vx = v.x;
	body->vy = v.y;
	body->w = flush_tiny(within(w, p->step.max_spin));
	if (forced)
	{
		p->motion[i].fx = 0.0f;
		p->motion[i].fy = 0.0f;
		p->motion[i].torque = 0.0f;
	}
}

// argument: 1 for the bodies that finalize_wide has listed, else 0.
KERNEL(finalize)
{
	finalize_body(p, BATCHED(p) && p->argument ? p->moved_bodies[i] : active_item(p, GROUPS_OF_BODIES, i));
}

// Item: a part of a body that moves far, or a pressed body. Moves the body until something obstructs it. A pressed body
// then slides along the obstacle and completes its rotation, or only slides. A body of one part slides too if the world
// has joints; otherwise a chain would press a stopped link ever harder. All searches share one call, because clang for
// PTX inlines no second call and would keep the pools on the stack: all kernels were slower on an H200.
KERNEL(continuous)
{
	Int2 item = p->continuous_list[i];
	int body = item.x, pressed = item.y < 0, slides = 0;
	ContinuousBody continuous_body = p->continuous_body[body];
	Vec d = vec(p->body[body].dx, p->body[body].dy), to = d;
	float da = p->body[body].da, turn = da, least = 0.0f;
	if (pressed)
		continuous_body.parts = 1;
	for (;;)
	{
		ContinuousStop stop = continuous_part(p, continuous_body, item.y, to, turn);
		if (slides)
		{
			if (stop.share > least)
			{
				d = vec_scale(stop.share, to);
				da = stop.share * turn;
			}
			if (!pressed || stop.share > least || slides == 2)
				break;
			turn = least * turn;
			slides = 2;
			continue;
		}
		if (!continuous_all(p, continuous_body, body, &stop.share))
			return;
		if (!(stop.share < 1.0f))
			break;
		Vec rest = vec_scale(1.0f - stop.share, d);
		if (!pressed || vec_dot(rest, stop.normal) < -CONTINUOUS_MOST)
			atomic_add_int(&p->counters->held, 1);
		d = vec_scale(stop.share, d);
		da = stop.share * da;
		if (continuous_body.parts > 1 || (!pressed && !bay_has_joints(p, body)))
			break;
		to = vec_add(d, vec_sub(rest, vec_scale(minimum(vec_dot(rest, stop.normal), 0.0f), stop.normal)));
		turn = pressed ? turn : da;
		least = stop.share;
		slides = 1;
	}
	finalize_pose(p, body, d, da);
}

#endif
