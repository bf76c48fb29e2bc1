// SPDX-License-Identifier: MIT
// chain_stiff.h -- starts a step of a chain: computes inertias that tension requires, and bodies that joints share.
//
// A link under tension is like a string: its sideways vibration may be faster than substeps can resolve, and the rope
// whips apart. So for the step the inertia of a link is raised to that of an implicit integration of the tension, if
// this is larger. All constraints use the raised inertia; constraints with different inertias would add energy.
//
// This work is based on:
// S. Andrews, M. Teichmann, J. Kovecses, Geometric Stiffness for Real-time Constrained Multibody Dynamics, 2017.
#ifndef CHAIN_STIFF_H
#define CHAIN_STIFF_H
#include "stages/solve/chain/chain_link.h"

// Maximum of inertia / damping of a damped free angle. With less damping, its inverse, the softness, could overflow
// sums.
#define CHAIN_SLACKEST 1.0e12f
#define CHAIN_SLOW     0.02f // factor of the inertia I in chain_slack

// Stores the bodies of a joint, their original inverse inertias, and the inertia, kg m^2, that its pull adds to each
// body.
INLINE void chain_tension(const Pools* p, const Chain* chain, int spot)
{
	ChainLink link;
	chain_load_posed(p, chain->begin + spot, &link);
	Real sum[JOINT_COORDINATES];
	joint_sums(p, chain->begin + spot, &link.u, sum);
	Vec push = joint_impulse(&link.c, sum[0], sum[1], splat(0.0f)).push;
	Real h = p->step.h * h_ratio_of(p, chain->begin + spot); // h_ratio, because the impulses are those of the last step
	CHAIN_PUT(p, tension[0], spot, -h * vec_dot(link.c.arm_a, push));
	CHAIN_PUT(p, tension[1], spot, h * vec_dot(link.c.arm_b, push));
	CHAIN_PUT_INT(p, body_a, spot, link.ia);
	CHAIN_PUT_INT(p, body_b, spot, link.ib);
	CHAIN_PUT(p, own_a, spot, link.c.a.inv_inertia);
	CHAIN_PUT(p, own_b, spot, link.c.b.inv_inertia);
}

typedef struct // bodies a and b of joints, masks of those that can move, and the tension of all joints at each body
{
	Int a, b, moves_a, moves_b;
	Real tension_a, tension_b;
} ChainBodies;

typedef struct // masks: body a, body b of a joint can move and is shared with the neighbor; it is the neighbor's body a
{
	Int here_a, here_b, there_a;
} ChainShared;

// Returns the bodies that joints share with their neighbors. Adds the neighbors' tension at these bodies to `bodies`.
INLINE ChainShared chain_share(const Pools* p, ChainNear neighbor, ChainBodies* bodies)
{
	Int a = chain_near_int(p->chain_joints->body_a, neighbor), b = chain_near_int(p->chain_joints->body_b, neighbor);
	Real tension[2];
	chain_near(p->chain_joints->tension, 2, neighbor, tension);
	ChainShared shared;
	shared.here_a = bodies->moves_a & ((bodies->a == a) | (bodies->a == b));
	shared.here_b = bodies->moves_b & ((bodies->b == a) | (bodies->b == b)) & (shared.here_a == 0);
	shared.there_a = (bodies->moves_a & (bodies->a == a)) | (bodies->moves_b & (bodies->b == a));
	Real pull = blend(tension[1], tension[0], shared.there_a);
	bodies->tension_a = blend(bodies->tension_a, bodies->tension_a + pull, shared.here_a);
	bodies->tension_b = blend(bodies->tension_b, bodies->tension_b + pull, shared.here_b);
	return shared;
}

// Returns 1 / inertia for the step. The inertia is that of the body, or the tension of its joints if the tension is
// larger and finite; at most MOST_INERTIA.
INLINE Real chain_inertia(Real inverse, Real tension)
{
	Real zero = splat(0.0f), more = only(tension - quotient(1.0f, inverse), inverse > zero);
	Int taut = (more > zero) & (more <= splat(MOST_FLOAT));
	return blend(inverse, quotient(1.0f, minimum(tension, splat(MOST_INERTIA))), taut);
}

// Returns the softness that damps the free angle between two links, 0 for no damping. An implicit integration of the
// tension t (kg m^2, the smaller one of the two bodies) would damp the rotation by t in a substep. The damping is less:
// t times t / (CHAIN_SLOW I + t), where 1 / I is the sum of the inverse inertias. This fraction of t is small for a
// pendulum, which keeps its energy, and large for links that swing against each other. The impulse acts between the two
// links, so a whirled rope keeps its momentum.
INLINE Real chain_slack(const Pools* p, int spot, const ChainBodies* bodies)
{
	Real zero = splat(0.0f), inverse = CHAIN_AT(p, own_a, spot) + CHAIN_AT(p, own_b, spot);
	Real t = maximum(minimum(CHAIN_AT(p, tension[0], spot), CHAIN_AT(p, tension[1], spot)), zero), more = t * inverse;
	Real damping = quotient(t * more, splat(CHAIN_SLOW) + more), least = splat(1.0f / CHAIN_SLACKEST);
	Int damps = bodies->moves_a & bodies->moves_b & (damping * inverse > least) & (damping <= splat(MOST_FLOAT));
	return only(quotient(splat(1.0f), damping), damps);
}

// Computes the bodies' inertias for the step, the softness of angles, and the bodies shared with the joints before.
INLINE void chain_stiffen(const Pools* p, const Chain* chain, ChainPlace place)
{
	int spot = place.spot;
	Real zero = splat(0.0f), one = splat(1.0f);
	ChainBodies bodies;
	bodies.a = CHAIN_INT(p, body_a, spot);
	bodies.b = CHAIN_INT(p, body_b, spot);
	Real mass_a = body_gather(p, bodies.a).inv_mass, mass_b = body_gather(p, bodies.b).inv_mass;
	bodies.moves_a = mass_a > zero;
	bodies.moves_b = mass_b > zero;
	ChainBodies own = bodies;
	bodies.tension_a = CHAIN_AT(p, tension[0], spot);
	bodies.tension_b = CHAIN_AT(p, tension[1], spot);
	ChainShared shared = chain_share(p, chain_neighbor(chain, place.row, place.n, -1), &bodies);
	chain_share(p, chain_neighbor(chain, place.row, place.n, 1), &bodies);
	Real step_a = chain_inertia(CHAIN_AT(p, own_a, spot), bodies.tension_a),
	     step_b = chain_inertia(CHAIN_AT(p, own_b, spot), bodies.tension_b);
	CHAIN_PUT(p, step_a, spot, step_a);
	CHAIN_PUT(p, step_b, spot, step_b);
	CHAIN_PUT(p, slack, spot, chain_slack(p, spot, &own));
	CHAIN_PUT(p, side, spot, only(one, shared.here_b));
	CHAIN_PUT(p, other, spot, blend(one, zero, shared.there_a));
	CHAIN_PUT(p, inv_mass, spot, blend(only(mass_b, shared.here_b), mass_a, shared.here_a));
	CHAIN_PUT(p, turns, spot, blend(step_a, step_b, shared.here_b));
}

// Clears the solution of inert joints at the end of row 0, which elimination by rows leaves: no other code sets it.
INLINE void chain_clear(const Pools* p, const Chain* chain)
{
	for (int n = (chain->at.count + chain_rows(chain) - 1) >> chain->at.bits; n < chain->at.length; ++n)
		for (int k = 0; k < 3; ++k)
			chain_at(p, x[k], chain->at.first + n) = 0.0f;
}

// Sets the inertias of a joint's bodies that can rotate. Two joints set the same value for their common body.
INLINE void chain_set_inertias(const Pools* p, int place, float inverse_a, float inverse_b)
{
	if (inverse_a > 0.0f)
		p->body[joint_row(p, body_a, place)].inv_inertia = inverse_a;
	if (inverse_b > 0.0f)
		p->body[joint_row(p, body_b, place)].inv_inertia = inverse_b;
}

INLINE_MEET void chain_stretch(const Pools* p, const Chain* chain)
{
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(at, chain, odd)
	chain_tension(p, chain, at.spot);
	if (LANES > 1 && !chain_side(chain))
		chain_clear(p, chain);
	group_meet();
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(at, chain, odd)
	chain_stiffen(p, chain, at);
	group_meet();
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(at, chain, odd)
	for (int k = at.spot; k < at.spot + LANES; ++k)
		chain_set_inertias(p, chain->begin + k, chain_at(p, step_a, k), chain_at(p, step_b, k));
	group_meet();
}

#endif
