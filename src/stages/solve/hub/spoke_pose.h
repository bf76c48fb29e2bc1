// SPDX-License-Identifier: MIT
// spoke_pose.h -- prepares a spoke for one kind of impulse (docs/design/hubs.md): limits, targets, masses, warm start.
#ifndef SPOKE_POSE_H
#define SPOKE_POSE_H
#include "stages/solve/hub/spoke_arms.h"

// Fraction of the hub's inverse mass that is added to the inverse mass of a neighbor; otherwise an immovable neighbor
// would be infinitely stiff. The solution stays the same, because the term multiplies changes of impulses only.
#define HUB_YIELD 0.1f

// The same fraction for restitution. It is smaller, because no later pass restores the impulse that it takes away.
#define BOUNCE_YIELD 0.001f

#define LEAST_RESISTS ABSORBS // 1/kg: a smaller inverse mass of a point counts as 0
#define HUB_SPEED     1.0e12f // m/s, rad/s: limit of velocities; a spoke with a higher one gets no impulse

// Returns whether a block is friction or rolling resistance, whose impulses have both signs and limits.
INLINE int spoke_limited(int what) { return what == HUB_FRICTION || what == HUB_ROLL; }

// Computes the limits of friction (N s) or rolling resistance (N m s); does nothing for other blocks.
INLINE void spoke_limits(const Pools* p, int i, int what, Real limit[2])
{
	Real normal[2];
	if (spoke_limited(what))
		spoke_impulses(p, i, HUB_NORMAL, normal);
	if (what == HUB_FRICTION)
	{
		Real friction = load(&contact_row(p, friction, i), 0);
		limit[0] = friction * normal[0];
		limit[1] = friction * normal[1];
	}
	else if (what == HUB_ROLL)
	{
		limit[0] = minimum(load(&contact_rare(p, rolling, i), 0) * (normal[0] + normal[1]), splat(MOST_IMPULSE));
		limit[1] = splat(0.0f);
	}
}

INLINE Real spoke_gap(const Pools* p, int i, int k)
{
	int m = spoke_of(p, i);
	return k ? load(&spoke_at(p, gap2, m), 0) : load(&spoke_at(p, gap1, m), 0);
}

INLINE Real spoke_rebound(const Pools* p, int i, int k)
{
	return k ? load(&contact_rare(p, rebound2, i), 0) : load(&contact_rare(p, rebound1, i), 0);
}

// 1/kg: Returns the change of the relative velocity at point k per unit of impulse, as if neither body were split.
INLINE Real spoke_resists(const Hub* h, const SpokeArms* s, int k)
{
	return h->whole.inv_mass + s->whole_mass + h->whole.inv_inertia * s->hub[k] * s->hub[k] +
	       s->whole_inertia * s->neighbor[k] * s->neighbor[k];
}

// Computes the target at point k. *bias, m/s: minus the target velocity. *soft, 1/kg: softness, added to inverse mass.
INLINE void spoke_wants(const Pools* p, const Hub* h, int i, int what, const SpokeArms* s, int k, Real* bias,
                        Real* soft)
{
	*bias = splat(0.0f);
	*soft = splat(0.0f);
	if (what == HUB_FRICTION && p->step.has_rolling)
		*bias = load(&contact_rare(p, tangent_speed, i), 0);
	if (what == HUB_FRICTION || what == HUB_ROLL)
		return;
	Real gap = spoke_gap(p, i, k);
	if (what == HUB_BOUNCE)
	{
		*bias = -bounce_speed(&p->step, spoke_rebound(p, i, k), load(&contact_rare(p, fall, i), 0), gap);
		return;
	}
	PairGoal goal = pair_goal(gap, s->whole_mass == splat(0.0f), splat(0.0f), &p->step, what == HUB_SOFT, 1);
	*bias = quotient(goal.bias, goal.mass_scale);
	*soft = quotient(spoke_resists(h, s, k) * goal.impulse_scale, goal.mass_scale);
}

// Returns whether a block may leave out points: restitution leaves out those that do not bounce or had no impulse,
// relax those that will bounce but have not touched yet.
INLINE int spoke_chooses(const Pools* p, int what)
{
	return what == HUB_BOUNCE || (what == HUB_NORMAL && p->step.bounces);
}

// Returns 1 if point k is solved, otherwise 0. old: its normal impulse.
INLINE Real spoke_takes_part(const Pools* p, int i, int what, int k, Real old)
{
	Real zero = splat(0.0f), one = splat(1.0f), rebound = spoke_rebound(p, i, k);
	if (what == HUB_NORMAL)
		return blend(one, zero, pair_waits(spoke_gap(p, i, k), old, rebound));
	Real total = k ? load(&contact_rare(p, total_impulse2, i), 0) : load(&contact_rare(p, total_impulse1, i), 0);
	return only(one, (rebound > zero) & (total > zero));
}

// m/s: Computes the separation velocities of the points of a spoke.
INLINE void spoke_speeds(const Hub* h, const SpokeArms* s, Real speed[2])
{
	for (int k = 0; k < 2; ++k)
		speed[k] = s->n.x * (h->from[0] - s->v.x) + s->n.y * (h->from[1] - s->v.y) + s->hub[k] * h->from[2] +
		           s->neighbor[k] * s->w;
}

typedef struct // problem of a spoke for one kind of impulse
{
	Real old[2], limit[2];     // N s
	Real mass[2], cross;       // 1/kg: change of velocity per unit of impulse: at the same, at the other point
	Real slope[2], inverse[2]; // m/s: velocity error that is left with the old impulses; kg: inverse of mass
	Int well;                  // mask: velocities and masses are finite
} SpokeProblem;

// Reduces impulses of friction and rolling resistance to their limits. Removes all impulses of a spoke with a velocity
// that is not finite or exceeds HUB_SPEED. Adds the effect on the hub to `taken`; updates the velocity of the neighbor.
INLINE void spoke_take_back(const Pools* p, const Hub* h, int i, int what, SpokeArms* s, SpokeProblem* r, Real taken[3])
{
	Real zero = splat(0.0f), most = splat(HUB_SPEED), held[2], beyond[2], push[3], speed[2];
	r->limit[0] = r->limit[1] = zero;
	spoke_impulses(p, i, what, r->old);
	spoke_speeds(h, s, speed);
	Int well0 = absolute(speed[0]) <= most, well1 = absolute(speed[1]) <= most;
	r->well = well0 & well1;
	int limited = spoke_limited(what), m = spoke_of(p, i);
	spoke_limits(p, i, what, r->limit);
	for (int k = 0; k < 2; ++k)
	{
		r->limit[k] = only(r->limit[k], r->well);
		held[k] = only(limited ? grip_of(r->old[k], r->limit[k]) : r->old[k], r->well);
		beyond[k] = held[k] - r->old[k];
	}
	Int adds = spoke_sum(h, s, beyond, push);
	for (int k = 0; k < 2; ++k)
	{
		beyond[k] = only(beyond[k], adds);
		r->old[k] = blend(r->old[k], held[k], adds);
	}
	for (int q = 0; q < 3; ++q)
		taken[q] += only(push[q], adds);
	spoke_push(p, i, *s, beyond[0], beyond[1]);
	s->v = vec(load(&spoke_at(p, vx, m), 0), load(&spoke_at(p, vy, m), 0));
	s->w = load(&spoke_at(p, w, m), 0);
}

// Computes masses and slopes of both points. All are 0 if one is not finite, or a velocity exceeds HUB_SPEED.
INLINE void spoke_masses(const Pools* p, const Hub* h, int i, int what, const SpokeArms* s, SpokeProblem* r)
{
	Real zero = splat(0.0f), most = splat(HUB_SPEED), speed[2];
	Real cross = s->mass + s->inertia * s->neighbor[0] * s->neighbor[1];
	float yield = what == HUB_BOUNCE ? BOUNCE_YIELD : HUB_YIELD;
	spoke_speeds(h, s, speed);
	for (int k = 0; k < 2; ++k)
	{
		Real bias, soft;
		spoke_wants(p, h, i, what, s, k, &bias, &soft);
		Real hub_mass = what == HUB_ROLL ? zero : splat(h->inv_mass);
		// slightly more than the inverse mass itself, so that two points at one place have a solution
		r->mass[k] = 1.0001f * (s->mass + s->inertia * s->neighbor[k] * s->neighbor[k]) +
		             yield * (hub_mass + h->inv_inertia * s->hub[k] * s->hub[k]) + soft;
		r->slope[k] = flush_tiny(speed[k] + bias + soft * r->old[k]);
		r->well = r->well & (absolute(r->slope[k]) <= most) & (r->mass[k] <= splat(MOST_FLOAT));
	}
	r->cross = only(cross, r->well);
	for (int k = 0; k < 2; ++k)
	{
		r->mass[k] = only(r->mass[k], r->well);
		r->slope[k] = only(r->slope[k], r->well);
	}
}

// Stores the limits (friction, rolling resistance), or marks the points that are solved (restitution, relax). Adapts
// the masses or their cross term to them, and inverts the masses.
INLINE void spoke_restrict(const Pools* p, int i, int what, SpokeProblem* r)
{
	Real zero = splat(0.0f);
	int m = spoke_of(p, i);
	if (spoke_limited(what))
	{
		// two points with limits resist together: the cross term is added to the mass of each
		Real together = only(absolute(r->cross), (r->limit[0] > zero) & (r->limit[1] > zero));
		r->mass[0] += together;
		r->mass[1] += together;
		store(&spoke_at(p, limit1, m), 0, r->limit[0]);
		store(&spoke_at(p, limit2, m), 0, r->limit[1]);
	}
	else if (spoke_chooses(p, what))
	{
		Real takes1 = spoke_takes_part(p, i, what, 0, r->old[0]), takes2 = spoke_takes_part(p, i, what, 1, r->old[1]);
		store(&spoke_at(p, limit1, m), 0, takes1);
		store(&spoke_at(p, limit2, m), 0, takes2);
		r->cross = takes1 * takes2 * r->cross;
	}
	for (int k = 0; k < 2; ++k)
		r->inverse[k] = only(quotient(1.0f, r->mass[k]), r->mass[k] > splat(LEAST_RESISTS));
}

// Prepares the problem of a spoke for one block. Adds the impulses on the hub that this removes to `taken`.
INLINE void spoke_pose(const Pools* p, const Hub* h, int i, int what, Real taken[3])
{
	SpokeArms s = spoke_arms(p, h, i, what);
	SpokeProblem r;
	int m = spoke_of(p, i);
	spoke_take_back(p, h, i, what, &s, &r, taken);
	spoke_masses(p, h, i, what, &s, &r);
	spoke_restrict(p, i, what, &r);
	store(&spoke_at(p, push_x, m), 0, s.n.x);
	store(&spoke_at(p, push_y, m), 0, s.n.y);
	store(&spoke_at(p, arm1, m), 0, s.hub[0]);
	store(&spoke_at(p, arm2, m), 0, s.hub[1]);
	store(&spoke_at(p, slope1, m), 0, r.slope[0]);
	store(&spoke_at(p, slope2, m), 0, r.slope[1]);
	store(&spoke_at(p, mass1, m), 0, r.mass[0]);
	store(&spoke_at(p, mass2, m), 0, r.mass[1]);
	store(&spoke_at(p, cross, m), 0, r.cross);
	store(&spoke_at(p, inverse1, m), 0, r.inverse[0]);
	store(&spoke_at(p, inverse2, m), 0, r.inverse[1]);
	if (!spoke_limited(what))
		store(&spoke_at(p, inverse, m), 0, quotient(1.0f, 1.0f - r.cross * r.inverse[0] * (r.cross * r.inverse[1])));
	store(&spoke_at(p, old1, m), 0, r.old[0]);
	store(&spoke_at(p, old2, m), 0, r.old[1]);
}

// Warm starts a spoke with the impulses of the last step. Adds their effect on the hub to `push`.
INLINE void spoke_warm(const Pools* p, const Hub* h, int i, int what, Real push[3])
{
	SpokeArms s = spoke_arms(p, h, i, what);
	Real old[2];
	spoke_impulses(p, i, what, old);
	if (what == HUB_NORMAL)
	{
		for (int k = 0; k < 2; ++k)
		{
			Real resists =
			    h->inv_mass + s.mass + h->inv_inertia * s.hub[k] * s.hub[k] + s.inertia * s.neighbor[k] * s.neighbor[k];
			old[k] = pair_start(&p->step, old[k], only(quotient(1.0f, resists), resists > splat(0.0f)));
		}
	}
	Real one[3];
	Int adds = spoke_sum(h, &s, old, one);
	for (int k = 0; k < 2; ++k)
		old[k] = only(old[k], adds);
	for (int q = 0; q < 3; ++q)
		push[q] += only(one[q], adds);
	spoke_push(p, i, s, old[0], old[1]);
	spoke_keep(p, i, what, old[0], old[1]);
}

INLINE void spoke_scale(const Pools* p, const Hub* h, int i, int what, float share)
{
	Real old[2];
	spoke_impulses(p, i, what, old);
	Real now1 = share * old[0], now2 = share * old[1];
	spoke_push(p, i, spoke_arms(p, h, i, what), now1 - old[0], now2 - old[1]);
	spoke_keep(p, i, what, now1, now2);
}

#endif
