// SPDX-License-Identifier: MIT
// integrate.h -- accelerates or moves bodies between two passes of the solve.
// Warm starting needs no pass over contacts. Anchors and normals are constant within a step, so the impulses of a
// substep change a velocity by the same amount in the next substep. This amount is the velocity after relax minus the
// velocity before any impulse (`base`).
#ifndef INTEGRATE_H
#define INTEGRATE_H
#include "constraints/bay_gravity.h"
#include "constraints/solver_body.h"
#include "dialect/finite.h"
#include "stages/edit/active.h"

// Adds the acceleration to velocities and, as warm start, the change by constraints in the previous substep. b, m,
// base: rows of the pools body, motion, base. In the first substep, b contains the warm start and base does not.
// gravity: m/s^2.
INLINE void body_accelerate(const Step* step, Vec gravity, Real* b, const Real* m, Real* base, int first)
{
	Vec v = vec(b[0], b[1]), contacts = vec_sub(v, vec(base[0], base[1]));
	Real w = b[2], contacts_w = w - base[2];
	if (first)
	{
		v = vec(base[0], base[1]);
		w = base[2];
	}

	// implicit damping, semi-implicit Euler; a lock sets the velocity to 0
	float h = step->h;
	Real linear = splat(1.0f), angular = splat(1.0f);
	if (lane_bits((m[4] != splat(0.0f)) | (m[5] != splat(0.0f))))
	{
		linear = quotient(1.0f, 1.0f + h * m[4]);
		angular = quotient(1.0f, 1.0f + h * m[5]);
	}
	v.x = m[6] * finite_of(linear * v.x + h * (gravity.x * m[3] + b[3] * m[0]));
	v.y = m[7] * finite_of(linear * v.y + h * (gravity.y * m[3] + b[3] * m[1]));
	w = number_of(angular * w + h * (b[7] * m[2])); // the limit below makes it finite

	// limits the velocity without the change by constraints: a limited change would not match the stored impulses
	v = vec_limit(v, step->max_speed);
	w = within(w, splat(step->max_spin));
	base[0] = v.x = flush_tiny(v.x);
	base[1] = v.y = flush_tiny(v.y);
	base[2] = w = flush_tiny(w);
	b[0] = flush_tiny(v.x + m[6] * contacts.x);
	b[1] = flush_tiny(v.y + m[7] * contacts.y);
	b[2] = flush_tiny(w + contacts_w);
}

INLINE void body_move(const Step* step, Real* b, const Real* m)
{
	// limits the motion: a rotation beyond half a turn would count as one in the other direction
	float h = step->h;
	b[4] = flush_tiny(b[4] + h * (m[6] * within(b[0], splat(step->max_speed))));
	b[5] = flush_tiny(b[5] + h * (m[7] * within(b[1], splat(step->max_speed))));
	b[6] = flush_tiny(b[6] + h * within(b[2], splat(step->max_spin)));
}

// argument: 1 in the first substep
WIDE_KERNEL(integrate_velocity)
{
	Real b[8], m[8], base[4];
	i = active_item(p, GROUPS_OF_BODIES, i);
	load_rows8((GLOBAL float*)p->body, i, b);
	load_rows8((GLOBAL float*)p->motion, i, m);
	load_rows4((GLOBAL float*)p->base, i, base);
	body_accelerate(&p->step, gravity_of(p, indices(i)), b, m, base, p->argument);
	store_rows8((GLOBAL float*)p->body, i, b);
	store_rows4((GLOBAL float*)p->base, i, base);
}

WIDE_KERNEL(integrate_position)
{
	Real b[8], m[8];
	i = active_item(p, GROUPS_OF_BODIES, i);
	load_rows8((GLOBAL float*)p->body, i, b);
	load_rows8((GLOBAL float*)p->motion, i, m);
	body_move(&p->step, b, m);
	store_rows8((GLOBAL float*)p->body, i, b);
}

#endif
