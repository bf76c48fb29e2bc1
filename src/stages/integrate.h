// SPDX-License-Identifier: MIT
// integrate.h -- what a body does between two passes of the solve: it accelerates, or moves.
//
// Warm starting takes no pass over the contacts. Anchors and normals are constant within a step, so that the velocity
// which all contacts together gave a body in one substep is what they would give it again: velocity after the relaxing
// pass less the velocity before any impulse (the pool base). integrate_velocity adds it to the next substep.
#ifndef INTEGRATE_H
#define INTEGRATE_H
#include "constraints/body.h"
#include "dialect/finite.h"

// Forces into velocity, and the contacts' share of the substep before as warm start. b is a row of the pool body, m of
// motion, base of base. In the first substep base still holds the velocity of the body alone, and the warm start has
// been added to it.
INLINE void body_accelerate(const Step* step, Real* b, const Real* m, Real* base, int first)
{
	Vec v = vec(b[0], b[1]), contacts = vec_sub(v, vec(base[0], base[1]));
	Real w = b[2], contacts_w = w - base[2];
	if (first)
	{
		v = vec(base[0], base[1]);
		w = base[2];
	}

	// implicit damping, semi-implicit Euler; a lock holds by taking the velocity away
	float h = step->h;
	Real linear = 1.0f / (1.0f + h * m[4]), angular = 1.0f / (1.0f + h * m[5]);
	v.x = m[6] * (linear * v.x + h * (step->gravity_x * m[3] + b[3] * m[0]));
	v.y = m[7] * (linear * v.y + h * (step->gravity_y * m[3] + b[3] * m[1]));
	w = angular * w + h * (b[7] * m[2]);

	// The limits hold for what the body does alone. The contacts' share must stay what their impulses make of it, or they
	// would take back what they have not given.
	v = vec_scale(vec_shrink(v, step->max_speed), v);
	w = within(no_infinity(w), splat(step->max_spin));
	base[0] = v.x;
	base[1] = v.y;
	base[2] = w;
	v.x = v.x + m[6] * contacts.x;
	v.y = v.y + m[7] * contacts.y;
	w = w + contacts_w;
	b[0] = v.x;
	b[1] = v.y;
	b[2] = w;
}

INLINE void body_move(const Step* step, Real* b, const Real* m)
{
	// within a substep impulses may exceed the limits. No way may: a turn beyond them could not be told from the other
	// way round, and a body would leap.
	float h = step->h;
	b[4] = b[4] + h * (m[6] * within(b[0], splat(step->max_speed)));
	b[5] = b[5] + h * (m[7] * within(b[1], splat(step->max_speed)));
	b[6] = b[6] + h * within(b[2], splat(step->max_spin));
}

// argument is 1 in the first substep
WIDE_STAGE(integrate_velocity)
{
	Real b[8], m[8], base[4];
	load_rows8((GLOBAL float*)p->body, i, b);
	load_rows8((GLOBAL float*)p->motion, i, m);
	load_rows4((GLOBAL float*)p->base, i, base);
	body_accelerate(&p->step, b, m, base, p->argument);
	store_rows8((GLOBAL float*)p->body, i, b);
	store_rows4((GLOBAL float*)p->base, i, base);
}

WIDE_STAGE(integrate_position)
{
	Real b[8], m[8];
	load_rows8((GLOBAL float*)p->body, i, b);
	load_rows8((GLOBAL float*)p->motion, i, m);
	body_move(&p->step, b, m);
	store_rows8((GLOBAL float*)p->body, i, b);
}

#endif
