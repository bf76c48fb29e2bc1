// SPDX-License-Identifier: MIT
// spoke_answer.h -- computes the response of a spoke: impulses that solve it for a fixed hub velocity (docs/design/hubs.md).
#ifndef SPOKE_ANSWER_H
#define SPOKE_ANSWER_H
#include "stages/solve/hub/spoke_pose.h"

// Number of sums of the responses. 0 to 2: impulse on the hub (x, y, angular). 3 to 8: minus its derivatives with
// respect to the hub's velocity (xx, xy, yy, xw, yw, ww). 9, 10: first derivative of the energy along the responses;
// second derivative without the energy of the hub.
#define HUB_SUMS 11

typedef struct // response: impulses; minus their derivatives by the hub's velocity at the same, at the other point
{
	Real impulse[2], own[2], cross;
} SpokeAnswer;

// Returns impulses at the two points, which never pull. Two positive ones bring both points to their target velocities,
// a single one brings its point there. want1, want2, m/s: velocities minus targets without any impulse.
INLINE SpokeAnswer spoke_push_apart(const Pools* p, int m, Real want1, Real want2)
{
	SpokeAnswer r;
	Real zero = splat(0.0f), inverse = load(&spoke_at(p, inverse, m), 0);
	Real single1 = load(&spoke_at(p, inverse1, m), 0), single2 = load(&spoke_at(p, inverse2, m), 0);
	Real own1 = inverse * single1, own2 = inverse * single2, cross = own1 * (single2 * load(&spoke_at(p, cross, m), 0));
	Real first = flush_tiny(cross * want2 - own1 * want1), second = flush_tiny(cross * want1 - own2 * want2);
	Int good1 = first >= zero, good2 = second >= zero, both = good1 & good2;
	Real alone1 = blend(maximum(flush_tiny(-single1 * want1), zero), zero, good2);
	Real alone2 = blend(maximum(flush_tiny(-single2 * want2), zero), zero, good1);
	r.impulse[0] = blend(alone1, first, both);
	r.impulse[1] = blend(alone2, second, both);
	r.own[0] = blend(only(single1, alone1 > zero), own1, both);
	r.own[1] = blend(only(single2, alone2 > zero), own2, both);
	r.cross = only(-cross, both);
	return r;
}

// Returns impulses within limits, for friction and rolling resistance. The two points are solved separately.
INLINE SpokeAnswer spoke_hold(const Pools* p, int m, const Real slope[2], const Real old[2])
{
	SpokeAnswer r;
	Real zero = splat(0.0f);
	Real limit[2] = {load(&spoke_at(p, limit1, m), 0), load(&spoke_at(p, limit2, m), 0)};
	Real inverse[2] = {load(&spoke_at(p, inverse1, m), 0), load(&spoke_at(p, inverse2, m), 0)};
	for (int k = 0; k < 2; ++k)
	{
		Real wanted = flush_tiny(old[k] - inverse[k] * slope[k]);
		r.impulse[k] = minimum(maximum(wanted, -limit[k]), limit[k]);
		r.own[k] = only(inverse[k], (wanted == r.impulse[k]) & (limit[k] > zero));
	}
	r.cross = zero;
	return r;
}

// Computes the response of a spoke to the hub's velocity, adds its terms to `sum`, and stores the impulses.
INLINE void spoke_answer(const Pools* p, const Hub* h, int i, int what, Real sum[HUB_SUMS])
{
	int m = spoke_of(p, i);
	Real x = load(&spoke_at(p, push_x, m), 0), y = load(&spoke_at(p, push_y, m), 0);
	Real arm[2] = {load(&spoke_at(p, arm1, m), 0), load(&spoke_at(p, arm2, m), 0)};
	Real old[2] = {load(&spoke_at(p, old1, m), 0), load(&spoke_at(p, old2, m), 0)};
	Real mass[2] = {load(&spoke_at(p, mass1, m), 0), load(&spoke_at(p, mass2, m), 0)};
	Real slope[2] = {load(&spoke_at(p, slope1, m), 0), load(&spoke_at(p, slope2, m), 0)};
	Real cross = load(&spoke_at(p, cross, m), 0);
	float dx = h->now[0] - h->from[0], dy = h->now[1] - h->from[1], dw = h->now[2] - h->from[2];
	float fx = h->free[0] - h->from[0], fy = h->free[1] - h->from[1], fw = h->free[2] - h->from[2];
	Real faster = x * dx + y * dy,
	     at[2] = {flush_tiny(slope[0] + (faster + arm[0] * dw)), flush_tiny(slope[1] + (faster + arm[1] * dw))};

	SpokeAnswer r;
	if (spoke_limited(what))
		r = spoke_hold(p, m, at, old);
	else
		r = spoke_push_apart(p, m, flush_tiny(at[0] - mass[0] * old[0] - cross * old[1]),
		                     flush_tiny(at[1] - mass[1] * old[1] - cross * old[0]));
	if (spoke_chooses(p, what))
	{
		Real takes[2] = {load(&spoke_at(p, limit1, m), 0), load(&spoke_at(p, limit2, m), 0)};
		for (int k = 0; k < 2; ++k)
		{
			r.impulse[k] = blend(old[k], r.impulse[k], takes[k] > splat(0.0f));
			r.own[k] = takes[k] * r.own[k];
		}
		r.cross = takes[0] * takes[1] * r.cross;
	}

	Real change[2] = {r.impulse[0] - old[0], r.impulse[1] - old[1]}, both = change[0] + change[1];
	Real add[HUB_SUMS] = {x * both, y * both, arm[0] * change[0] + arm[1] * change[1]};
	Real stiff = r.own[0] + r.own[1] + 2.0f * r.cross;
	Real lever = r.own[0] * arm[0] + r.own[1] * arm[1] + r.cross * (arm[0] + arm[1]);
	add[3] = x * x * stiff;
	add[4] = x * y * stiff;
	add[5] = y * y * stiff;
	add[6] = x * lever;
	add[7] = y * lever;
	add[8] = r.own[0] * arm[0] * arm[0] + r.own[1] * arm[1] * arm[1] + 2.0f * r.cross * arm[0] * arm[1];
	Real freely = x * fx + y * fy;
	add[9] = change[0] * (slope[0] + (freely + arm[0] * fw)) + change[1] * (slope[1] + (freely + arm[1] * fw));
	Real bend[2] = {mass[0] * change[0] * change[0], mass[1] * change[1] * change[1]};
	add[10] = bend[0] + bend[1] + 2.0f * cross * change[0] * change[1];

	// keeps the old impulses if a new one exceeds MOST_IMPULSE, or a term could overflow its sum
	Int finite0 = absolute(r.impulse[0]) <= splat(MOST_IMPULSE),
	    finite1 = absolute(r.impulse[1]) <= splat(MOST_IMPULSE);
	Int adds = finite0 & finite1 & spoke_adds(h, bend[0]) & spoke_adds(h, bend[1]);
	for (int q = 0; q < HUB_SUMS; ++q)
		adds = adds & spoke_adds(h, add[q]);
	for (int q = 0; q < HUB_SUMS; ++q)
		sum[q] += only(add[q], adds);
	store(&spoke_at(p, new1, m), 0, blend(old[0], r.impulse[0], adds));
	store(&spoke_at(p, new2, m), 0, blend(old[1], r.impulse[1], adds));
}

// Applies the fraction `part` of the response of a spoke. Clamps impulses, because rounding may exceed their limits.
INLINE void spoke_give(const Pools* p, const Hub* h, int i, int what, float part)
{
	int m = spoke_of(p, i), limited = spoke_limited(what);
	Real old[2] = {load(&spoke_at(p, old1, m), 0), load(&spoke_at(p, old2, m), 0)};
	Real now[2] = {old[0] + part * (load(&spoke_at(p, new1, m), 0) - old[0]),
	               old[1] + part * (load(&spoke_at(p, new2, m), 0) - old[1])};
	now[0] = limited ? grip_of(now[0], load(&spoke_at(p, limit1, m), 0)) : push_of(now[0]);
	now[1] = limited ? grip_of(now[1], load(&spoke_at(p, limit2, m), 0)) : push_of(now[1]);
	spoke_push(p, i, spoke_arms(p, h, i, what), now[0] - old[0], now[1] - old[1]);
	spoke_keep(p, i, what, now[0], now[1]);
}

#endif
