// SPDX-License-Identifier: MIT
// solver_body.h -- reads and writes bodies in the solver: those of a constraint, or LANES consecutive ones.
#ifndef SOLVER_BODY_H
#define SOLVER_BODY_H
#include "dialect/vec.h"
#include "pools/pools.h"

typedef struct
{
	Vec v;
	Real w, inv_mass;
	Vec d; // motion since the start of the step
	Real da, inv_inertia;
	Real sine, versine; // sine of da, and cosine minus 1
} Body;

// Computes sine and cosine - 1 of da by series. Error: 2e-4 at 1 rad; 0.53 at pi, the maximum that max_spin allows.
INLINE void body_turn(Body* b)
{
	Real square = b->da * b->da;
	b->sine = b->da * (1.0f - square * (1.0f / 6.0f - square * (1.0f / 120.0f)));
	b->versine = -square * (0.5f - square * (1.0f / 24.0f - square * (1.0f / 720.0f)));
}

INLINE Body body_gather(const Pools* p, Int index)
{
	Real row[8];
	gather_rows8((GLOBAL float*)p->body, index, row);
	Body b;
	b.v = vec(row[0], row[1]);
	b.w = row[2];
	b.inv_mass = row[3];
	b.d = vec(row[4], row[5]);
	b.da = row[6];
	b.inv_inertia = row[7];
	body_turn(&b);
	return b;
}

// Writes velocities back, except in lanes whose body cannot move: many constraints of a color may share such a body.
INLINE void body_scatter(const Pools* p, Int index, Body b)
{
	Real row[4];
	row[0] = b.v.x;
	row[1] = b.v.y;
	row[2] = b.w;
	row[3] = b.inv_mass;
	scatter_rows4of8((GLOBAL float*)p->body, index, row, b.inv_mass > splat(0.0f));
}

// Returns the displacement, since the start of the step, of the point at arm r from the center of mass.
INLINE Vec body_displacement(Body b, Vec r)
{
	return vec(b.d.x + (b.versine * r.x - b.sine * r.y), b.d.y + (b.sine * r.x + b.versine * r.y));
}

// Returns the displacement of the point at arm r to first order, for contacts: a wheel that turns does not leave the
// ground, although the point that touched does. Prepared separations correct gaps at the end of the step.
INLINE Vec body_shift(Body b, Vec r) { return vec_add(b.d, vec_spin(b.da, r)); }

INLINE Vec body_velocity_at(Body b, Vec r) { return vec_add(b.v, vec_spin(b.w, r)); }

// Applies the impulse j to body b at the arm rb, and its opposite to body a at the arm ra.
INLINE void body_push(Body* a, Vec ra, Body* b, Vec rb, Vec j)
{
	a->v = vec_sub(a->v, vec_scale(a->inv_mass, j));
	a->w = a->w - a->inv_inertia * vec_cross(ra, j);
	b->v = vec_add(b->v, vec_scale(b->inv_mass, j));
	b->w = b->w + b->inv_inertia * vec_cross(rb, j);
}

// Returns the effective mass of two bodies for an impulse along n; 0 if neither can move.
INLINE Real body_effective_mass(Body a, Vec ra, Body b, Vec rb, Vec n)
{
	Real na = vec_cross(ra, n), nb = vec_cross(rb, n);
	Real k = a.inv_mass + b.inv_mass + a.inv_inertia * na * na + b.inv_inertia * nb * nb;
	return only(quotient(1.0f, k), k > splat(0.0f));
}

#endif
