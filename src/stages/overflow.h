// SPDX-License-Identifier: MIT
// overflow.h -- the contacts that found no color, solved all at once by mass splitting.
//
// This work is based on:
// Richard Tonge, Feodor Benevolenski, Andrey Voroshilov, Mass Splitting for Jitter-Free Parallel Rigid Body Simulation, 2012.
//
// A body with n such contacts is split into n shares of 1/n of its mass, one a contact. Each contact moves its own
// shares; then the body takes the mean of their velocities. Momentum is kept, and no order matters but that of the sum,
// which is fixed (overflow_one.h).
#ifndef OVERFLOW_H
#define OVERFLOW_H
#include "stages/solve.h"

#define OVERFLOW_PASS(name)                                                                  \
	WIDE_STAGE(overflow_##name)                                                              \
	{                                                                                        \
		int k = i - p->counters->color_begin[COLORS];                                        \
		Pair c = pair_load(p, i);                                                            \
		Pair whole = c;                                                                      \
		Real split_a = load(p->overflow_split_a, k), split_b = load(p->overflow_split_b, k); \
		c.a.inv_mass = c.a.inv_mass * split_a;                                               \
		c.a.inv_inertia = c.a.inv_inertia * split_a;                                         \
		c.b.inv_mass = c.b.inv_mass * split_b;                                               \
		c.b.inv_inertia = c.b.inv_inertia * split_b;                                         \
		name##_pass(p, i, &c);                                                               \
		Real delta[8];                                                                       \
		delta[0] = c.a.v.x - whole.a.v.x;                                                    \
		delta[1] = c.a.v.y - whole.a.v.y;                                                    \
		delta[2] = c.a.w - whole.a.w;                                                        \
		delta[3] = splat(0.0f);                                                              \
		delta[4] = c.b.v.x - whole.b.v.x;                                                    \
		delta[5] = c.b.v.y - whole.b.v.y;                                                    \
		delta[6] = c.b.w - whole.b.w;                                                        \
		delta[7] = splat(0.0f);                                                              \
		store_rows8((GLOBAL float*)p->overflow_delta, k, delta);                             \
	}
OVERFLOW_PASS(warm_start)
OVERFLOW_PASS(bias)
OVERFLOW_PASS(relax)
OVERFLOW_PASS(bounce)

#endif
