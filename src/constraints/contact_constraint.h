// SPDX-License-Identifier: MIT
// contact_constraint.h -- a contact as a constraint: impulses at two points, friction, rolling resistance, restitution.
//
// This work is based on:
// Erin Catto, Soft Constraints, GDC 2011: bias rate, mass scale and impulse scale of a constraint with a frequency.
// Miles Macklin et al., Small Steps in Physics Simulation, 2019: substeps instead of iterations.
// Erin Catto, Solver2D, 2024: a bias pass and a relax pass per substep ("soft step").
#ifndef CONTACT_CONSTRAINT_H
#define CONTACT_CONSTRAINT_H
#include "constraints/bay_gravity.h"
#include "constraints/constraint.h"
#include "constraints/solver_body.h"
#include "dialect/finite.h"

#define IN_ARMS     (IN_PASSES | IN_PREPARE_BOUNCE)
#define IN_GAPS     (IN_BIAS | IN_RELAX | IN_BOUNCE)
#define IN_TANGENTS (IN_WARM_START | IN_RELAX)

// Rows that contacts need in every world.
#define CONTACT_ROWS(X)                                                                 \
	/* unit normal from collidable a to collidable b */                                 \
	X(normal_x, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                            \
	X(normal_y, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                            \
	/* m: center of body a minus center of body b; anchor + offset is relative to b */  \
	X(offset_x, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                            \
	X(offset_y, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                            \
	/* m: points 1 and 2, relative to the center of mass of body a */                   \
	X(anchor1_x, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                           \
	X(anchor1_y, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                           \
	X(anchor2_x, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                           \
	X(anchor2_y, always, PREPARED, 0.0f, IN_ARMS, IN_PREPARE)                           \
	/* m: separation at the start of the step; NO_POINT for a missing point */          \
	X(separation1, always, PREPARED, NO_POINT, IN_GAPS | IN_PREPARE_BOUNCE, IN_PREPARE) \
	X(separation2, always, PREPARED, NO_POINT, IN_GAPS | IN_PREPARE_BOUNCE, IN_PREPARE) \
	/* impulses, N s */                                                                 \
	X(normal_impulse1, always, KEPT, 0.0f, IN_PASSES, IN_PASSES)                        \
	X(normal_impulse2, always, KEPT, 0.0f, IN_PASSES, IN_PASSES)                        \
	X(tangent_impulse1, always, KEPT, 0.0f, IN_TANGENTS, IN_RELAX)                      \
	X(tangent_impulse2, always, KEPT, 0.0f, IN_TANGENTS, IN_RELAX)                      \
	X(friction, always, PLACED, 0.0f, IN_RELAX, IN_NONE)

// Rows that only some worlds need.
#define CONTACT_RARE_ROWS(X)                                                                         \
	/* units of these rows: 1, m, m/s */                                                             \
	X(restitution, bounces, PLACED, 0.0f, IN_PREPARE_BOUNCE, IN_NONE)                                \
	X(rolling, has_rolling, PLACED, 0.0f, IN_RELAX, IN_NONE)                                         \
	X(tangent_speed, has_rolling, PLACED, 0.0f, IN_RELAX, IN_NONE)                                   \
	/* impulse, N m s */                                                                             \
	X(rolling_impulse, has_rolling, KEPT, 0.0f, IN_TANGENTS, IN_RELAX)                               \
	/* m/s^2: normal acceleration by gravity and forces */                                           \
	X(fall, bounces, PREPARED, 0.0f, IN_BOUNCE, IN_PREPARE_BOUNCE)                                   \
	/* J: energy that the bodies may have after a bounce (prepare_energy) */                         \
	X(energy, bounces, PREPARED, 0.0f, IN_BOUNCE, IN_PREPARE_BOUNCE)                                 \
	/* m/s: speed at which a point leaves the surface, 0 if it does not bounce */                    \
	X(rebound1, bounces, PREPARED, 0.0f, IN_GAPS, IN_PREPARE_BOUNCE)                                 \
	X(rebound2, bounces, PREPARED, 0.0f, IN_GAPS, IN_PREPARE_BOUNCE)                                 \
	/* N s: sums of the normal impulses over all substeps */                                         \
	X(total_impulse1, rare, PREPARED, 0.0f, IN_RELAX | IN_BOUNCE, IN_PREPARE | IN_RELAX | IN_BOUNCE) \
	X(total_impulse2, rare, PREPARED, 0.0f, IN_RELAX | IN_BOUNCE, IN_PREPARE | IN_RELAX | IN_BOUNCE) \
	/* m/s: approach speeds of the points at the start of the step */                                \
	X(approach1, details, PREPARED, 0.0f, IN_NONE, IN_PREPARE)                                       \
	X(approach2, details, PREPARED, 0.0f, IN_NONE, IN_PREPARE)

// Columns of the stream (src/opencl/forms/registers.cl), for forms of the solve that do not keep contacts in registers.
// QUAD(k, four numbers): column k of float4; `name` is a number of the caller. PAIR(k, passes that read the pair,
// passes that write it, two numbers): column k of float2. The last pass of a step writes to the rows instead.
#define CONTACT_STREAM(QUAD, PAIR)                                      \
	QUAD(0, name, u->friction, u->normal_x, u->normal_y)                \
	QUAD(1, u->anchor1_x, u->anchor1_y, u->anchor2_x, u->anchor2_y)     \
	QUAD(2, u->offset_x, u->offset_y, u->separation1, u->separation2)   \
	PAIR(0, IN_GAPS, IN_NONE, u->normal_mass1, u->normal_mass2)         \
	PAIR(1, IN_RELAX, IN_NONE, u->tangent_mass1, u->tangent_mass2)      \
	PAIR(2, IN_PASSES, IN_GAPS, u->normal_impulse1, u->normal_impulse2) \
	PAIR(3, IN_TANGENTS | IN_BOUNCE, IN_RELAX, u->tangent_impulse1, u->tangent_impulse2)

// Bytes that the preparation of a contact gathers from pools; flags are gathered only if some shapes are round.
// CONTACT_BOUNCE_GATHERS: bytes gathered from its bodies, if some attribute has restitution.
#define CONTACT_GATHERS(step) \
	(sizeof(Int2) + 2 * sizeof(WorldShape) + sizeof(LocalManifold) + ((step)->round ? sizeof(Word) : 0))
#define CONTACT_BOUNCE_GATHERS (2 * (sizeof(BodyState) + sizeof(Motion) + sizeof(Word64)))

#define CONTACT_RARE(step) STEP_RARE(*(step))

struct ContactRows
{
	CONSTRAINT_ENDS
	CONTACT_ROWS(ROW_MEMBER)
};
struct ContactRareRows
{
	CONTACT_RARE_ROWS(ROW_MEMBER)
};
struct ContactKept
{
	CONTACT_ROWS(ROW_KEPT_MEMBER)
} KEPT_ALIGNED;
struct ContactRareKept
{
	CONTACT_RARE_ROWS(ROW_KEPT_MEMBER)
};

#define contact_row(p, name, i)  ((p)->contact_rows[(i) / MAX_LANES].name[(i) % MAX_LANES])
#define contact_rare(p, name, i) ((p)->contact_rare_rows[(i) / MAX_LANES].name[(i) % MAX_LANES])

typedef struct // a contact in registers
{
	CONTACT_ROWS(ROW_REGISTER)
	Real normal_mass1, normal_mass2, tangent_mass1, tangent_mass2; // kg: effective masses, constant within a step
} Contact;

typedef struct // the part of a pass that depends on the positions of the bodies, and not on their velocities
{
	Real gap[2]; // m: gaps of the points
} ContactReady;

typedef struct // the bodies of a contact, and the lever arms of its points
{
	Body a, b;
	Vec n, t;         // unit vectors: normal from body a to body b; tangent
	Vec ra[2], rb[2]; // m: arms from the centers of mass to the points
} ContactArms;

INLINE ContactArms pair_of(const Contact* u, const Body* a, const Body* b)
{
	ContactArms c;
	Vec offset = vec(u->offset_x, u->offset_y);
	c.a = *a;
	c.b = *b;
	c.n = vec(u->normal_x, u->normal_y);
	c.t = vec(u->normal_y, -u->normal_x);
	c.ra[0] = vec(u->anchor1_x, u->anchor1_y);
	c.ra[1] = vec(u->anchor2_x, u->anchor2_y);
	c.rb[0] = vec_add(c.ra[0], offset);
	c.rb[1] = vec_add(c.ra[1], offset);
	return c;
}

// m/s: Returns the velocity of body b relative to body a at point k, along n. With the normal: negative on approach.
INLINE Real pair_approach(ContactArms c, int k, Vec n)
{
	return vec_dot(vec_sub(body_velocity_at(c.b, c.rb[k]), body_velocity_at(c.a, c.ra[k])), n);
}

// m: Returns the current separation of point k. separation: its value at the start of the step.
INLINE Real pair_gap(const ContactArms* c, int k, Real separation)
{
	Vec moved = vec_sub(body_shift(c->b, c->rb[k]), body_shift(c->a, c->ra[k]));
	return separation + vec_dot(moved, c->n);
}

INLINE Real pair_mass(const ContactArms* c, int k, Vec n)
{
	return body_effective_mass(c->a, c->ra[k], c->b, c->rb[k], n);
}

// m/s, rad/s: Returns a speed before an effective mass multiplies it (HEAVY_MASS).
INLINE Real pair_speed(const Step* step, Real speed) { return step->heavy ? flush_tiny(speed) : speed; }

typedef struct // goal of a point's impulse: velocity bias, m/s; softness as in the struct Softness
{
	Real bias, mass_scale, impulse_scale;
} PairGoal;

// Returns the goal of a point with separation s, m. soft: 1 in bias; relax (0) ignores the overlap, and so removes the
// velocity of the push. fixed: mask of lanes in which one body cannot move; their contacts are firmer, so nothing sinks
// into the ground. depth: m, Softness.depth. exact: 1 if other contacts of the bodies are solved together with it; then the
// whole overlap is firm, and depth is not used.
INLINE PairGoal pair_goal(Real s, Int fixed, Real depth, const Step* step, int soft, int exact)
{
	Int apart = s >= splat(TINY);

	// speculative contact (s > 0): the point gets an impulse only if its gap would close within the substep
	PairGoal goal;
	goal.bias = only(s * step->inv_h, apart);
	goal.mass_scale = splat(1.0f);
	goal.impulse_scale = splat(0.0f);
	if (!soft)
		return goal;

	// the speed of the push is limited, but its impulse must reach that of the unlimited spring; otherwise deep bodies
	// would cluster, because more overlap would not push harder. So impulse_scale is reduced by the same factor
	Real rate = blend(splat(step->pair.mass_scale * step->pair.bias_rate),
	                  splat(step->fixed.mass_scale * step->fixed.bias_rate), fixed);
	Real firm = blend(splat(step->pair.firm), splat(step->fixed.firm), fixed);
	Real push = rate * (s + firm * (exact ? s : maximum(s, -depth))), most = splat(-step->push_speed);
	Real leak = blend(splat(step->pair.impulse_scale), splat(step->fixed.impulse_scale), fixed);
	Int limited = push < most;
	if (lane_bits(limited)) // the test often saves a division, because few lanes are limited
		leak = leak * blend(splat(1.0f), quotient(most, push), limited);
	Real mass_scale = blend(splat(step->pair.mass_scale), splat(step->fixed.mass_scale), fixed);
	goal.bias = blend(maximum(push, most), goal.bias, apart);
	goal.mass_scale = blend(mass_scale, goal.mass_scale, apart);
	goal.impulse_scale = blend(leak, goal.impulse_scale, apart);
	return goal;
}

// Returns whether a point that will bounce (rebound > 0) has a gap (s > 0) and no impulse so far (old = 0).
INLINE Int pair_waits(Real s, Real old, Real rebound)
{
	return (s >= splat(TINY)) & (rebound > splat(0.0f)) & (old == splat(0.0f));
}

#define PAIR_OWN 0.001f // two points nearly coincide if 1 - pair_cross^2 * (product of effective masses) is below this

// 1/kg: Returns the normal velocity that a unit impulse at one point causes at the other.
INLINE Real pair_cross(const ContactArms* c)
{
	return c->a.inv_mass + c->b.inv_mass + c->a.inv_inertia * vec_cross(c->ra[0], c->n) * vec_cross(c->ra[1], c->n) +
	       c->b.inv_inertia * vec_cross(c->rb[0], c->n) * vec_cross(c->rb[1], c->n);
}

// Solves the normal impulses of both points together: a linear complementarity problem, because no impulse is negative.
// Solved one after the other, the points would turn a box in each pass, and relax would not remove all velocity of a
// push. gap: separations, m; mass: effective masses, kg. In relax, a point that will bounce but has not touched yet
// (pair_waits) gets no impulse; otherwise it would bounce too early, or not at all.
INLINE void pair_normals(const Pools* p, int i, ContactArms* c, const Real gap[2], const Real mass[2], int soft,
                         const Real rebound[2], Real impulse[2])
{
	const Step* step = &p->step;
	Int fixed = (c->a.inv_mass == splat(0.0f)) | (c->b.inv_mass == splat(0.0f));
	Real zero = splat(0.0f), depth = soft ? depth_of(p, i, fixed) : zero, lever_a[2], lever_b[2];
	// change, N s: change of an impulse if the other impulse stays the same; yield, kg: `change` per m/s of approach
	Real change[2], yield[2];
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		PairGoal goal = pair_goal(gap[k], fixed, depth, step, soft, 0);
		lever_a[k] = vec_cross(c->ra[k], c->n);
		lever_b[k] = vec_cross(c->rb[k], c->n);
		Real approach = vec_dot(vec_sub(c->b.v, c->a.v), c->n) + (c->b.w * lever_b[k] - c->a.w * lever_a[k]);
		Real lack = pair_speed(step, goal.mass_scale * approach + goal.bias);
		change[k] = -mass[k] * lack - goal.impulse_scale * impulse[k];
		yield[k] = mass[k] * goal.mass_scale;
		if (step->bounces && !soft)
		{
			Int waits = pair_waits(gap[k], impulse[k], rebound[k]);
			change[k] = blend(change[k], zero, waits);
			yield[k] = blend(yield[k], zero, waits);
		}
	}

	Real cross = pair_cross(c);
	Real by1 = yield[0] * cross, by0 = yield[1] * cross, own = 1.0f - by0 * by1;

	// change of the second impulse if both points push, limited so that this impulse is not negative; then the first
	// point is solved with this change, and the second again with the change of the first
	Real second = only(quotient(change[1] - by0 * change[0], own), own > splat(PAIR_OWN));
	Real first = push_of(impulse[0] + (change[0] - by1 * maximum(second, -impulse[1]))) - impulse[0];
	second = push_of(impulse[1] + (change[1] - by0 * first)) - impulse[1];
	impulse[0] = impulse[0] + first;
	impulse[1] = impulse[1] + second;
	Vec push = vec_scale(first + second, c->n);
	c->a.v = vec_sub(c->a.v, vec_scale(c->a.inv_mass, push));
	c->a.w = c->a.w - c->a.inv_inertia * (lever_a[0] * first + lever_a[1] * second);
	c->b.v = vec_add(c->b.v, vec_scale(c->b.inv_mass, push));
	c->b.w = c->b.w + c->b.inv_inertia * (lever_b[0] * first + lever_b[1] * second);
}

// Solves the friction of one point, and returns its new tangent impulse. limit, N s: Coulomb's limit, from the normal
// impulse of the relax pass; speed: tangent speed of the surfaces, m/s; old: previous tangent impulse.
INLINE Real pair_tangent(const Step* step, ContactArms* c, int k, Real mass, Real speed, Real limit, Real old)
{
	Real impulse = grip_of(old - mass * pair_speed(step, pair_approach(*c, k, c->t) + speed), limit);
	body_push(&c->a, c->ra[k], &c->b, c->rb[k], vec_scale(impulse - old, c->t));
	return impulse;
}

// Solves rolling resistance: an angular impulse against the relative spin, at most the load times a lever arm. The load
// is the normal impulse of relax; that of bias varies within a step, so a fast roller would stop too early.
INLINE void pair_roll(const Pools* p, int i, ContactArms* c, Real weight)
{
	Real inertia = c->a.inv_inertia + c->b.inv_inertia;
	Real mass = only(quotient(1.0f, inertia), inertia > splat(0.0f));
	Real limit = minimum(load(&contact_rare(p, rolling, i), 0) * weight, splat(MOST_IMPULSE));
	Real old = load(&contact_rare(p, rolling_impulse, i), 0);
	Real impulse = grip_of(old - mass * pair_speed(&p->step, c->b.w - c->a.w), limit);
	c->a.w = c->a.w - c->a.inv_inertia * (impulse - old);
	c->b.w = c->b.w + c->b.inv_inertia * (impulse - old);
	store(&contact_rare(p, rolling_impulse, i), 0, impulse);
}

INLINE void pair_total(const Pools* p, int i, Real normal1, Real normal2)
{
	store(&contact_rare(p, total_impulse1, i), 0, load(&contact_rare(p, total_impulse1, i), 0) + normal1);
	store(&contact_rare(p, total_impulse2, i), 0, load(&contact_rare(p, total_impulse2, i), 0) + normal2);
}

INLINE void pair_push(const Pools* p, int i, ContactArms* c, Real normal1, Real normal2, Real tangent1, Real tangent2)
{
	body_push(&c->a, c->ra[0], &c->b, c->rb[0], vec_add(vec_scale(normal1, c->n), vec_scale(tangent1, c->t)));
	body_push(&c->a, c->ra[1], &c->b, c->rb[1], vec_add(vec_scale(normal2, c->n), vec_scale(tangent2, c->t)));
	if (p->step.has_rolling)
	{
		Real rolling = load(&contact_rare(p, rolling_impulse, i), 0);
		c->a.w = c->a.w - c->a.inv_inertia * rolling;
		c->b.w = c->b.w + c->b.inv_inertia * rolling;
	}
}

// Computes the normal impulses that together add lack1 and lack2, m/s, to the normal velocities of the points. If the
// points nearly coincide, *impulse1 adds lack1 and *impulse2 is 0.
INLINE void pair_joint(const ContactArms* c, Real mass1, Real mass2, Real lack1, Real lack2, Real* impulse1,
                       Real* impulse2)
{
	Real cross = pair_cross(c);
	Real share = 1.0f - cross * mass1 * cross * mass2;
	Int one = share < splat(PAIR_OWN);
	*impulse1 = blend(quotient(mass1 * (lack1 - cross * mass2 * lack2), share), mass1 * lack1, one);
	*impulse2 = blend(quotient(mass2 * (lack2 - cross * mass1 * lack1), share), splat(0.0f), one);
}

// Stops the approach of two points at the same time, if both will bounce. Solved one after the other, the points would
// rotate a body that lands flat, and friction would turn that rotation into a velocity along the surface.
INLINE void pair_meet(const Pools* p, int i, ContactArms* c, Real gap1, Real gap2, Real mass1, Real mass2,
                      Real* normal1, Real* normal2)
{
	Real zero = splat(0.0f), delta1, delta2;
	Real lack1 = flush_tiny(-(pair_approach(*c, 0, c->n) + maximum(gap1, zero) * p->step.inv_h)),
	     lack2 = flush_tiny(-(pair_approach(*c, 1, c->n) + maximum(gap2, zero) * p->step.inv_h));
	pair_joint(c, mass1, mass2, lack1, lack2, &delta1, &delta2);
	Int meet = (load(&contact_rare(p, rebound1, i), 0) > zero) & (load(&contact_rare(p, rebound2, i), 0) > zero);
	Real new1 = *normal1 + delta1, new2 = *normal2 + delta2;

	// if only one point pushes, the impulses are left to pair_normals
	meet = meet & ((new1 < zero) == (new2 < zero));
	new1 = blend(*normal1, push_of(new1), meet);
	new2 = blend(*normal2, push_of(new2), meet);
	body_push(&c->a, c->ra[0], &c->b, c->rb[0], vec_scale(new1 - *normal1, c->n));
	body_push(&c->a, c->ra[1], &c->b, c->rb[1], vec_scale(new2 - *normal2, c->n));
	*normal1 = new1;
	*normal2 = new2;
}

// m/s: Returns the speed, at the height `gap`, of a point that left the surface with the speed `rebound`. fall: normal
// acceleration, m/s^2, whose effect in half a substep is subtracted (prepare_rebound).
INLINE Real bounce_speed(const Step* step, Real rebound, Real fall, Real gap)
{
	return root(maximum(rebound * rebound + 2.0f * fall * gap, splat(0.0f))) - 0.5f * step->h * fall;
}

// J: Returns the kinetic energy of the relative motion of two bodies. If one cannot move, the energy is measured in the
// frame of this body, whose motion is prescribed. If both can move, uniform gravity does not change the energy.
INLINE Real pair_energy(const ContactArms* c)
{
	Real zero = splat(0.0f), one = splat(1.0f), mass = c->a.inv_mass + c->b.inv_mass;
	Int moves_a = c->a.inv_mass > zero, moves_b = c->b.inv_mass > zero;
	Int turns_a = c->a.inv_inertia > zero, turns_b = c->b.inv_inertia > zero;
	Vec a = vec_blend(body_velocity_at(c->a, c->ra[0]), c->a.v, moves_a),
	    b = vec_blend(body_velocity_at(c->b, c->rb[0]), c->b.v, moves_b), v = vec_sub(b, a);
	Real speed = flush_below(vec_dot(v, v), ABSORBS); // the square; masses would make denormals count
	Real spin_a = flush_below(c->a.w * c->a.w, ABSORBS), spin_b = flush_below(c->b.w * c->b.w, ABSORBS);
	Real energy = quotient(speed, blend(one, mass, mass > zero));
	energy = energy + only(quotient(spin_a, blend(one, c->a.inv_inertia, turns_a)), turns_a);
	energy = energy + only(quotient(spin_b, blend(one, c->b.inv_inertia, turns_b)), turns_b);
	return 0.5f * energy;
}

// J: Returns an upper bound of the bodies' gain of energy if the squared speeds of the points grow by more1 and more2.
INLINE Real pair_gained(const ContactArms* c, Real more1, Real more2)
{
	Real zero = splat(0.0f), mass = c->a.inv_mass + c->b.inv_mass;
	return quotient(0.5f * maximum(maximum(more1, more2), zero), blend(splat(1.0f), mass, mass > zero));
}

// Returns the largest fraction, from 0 to 1, of two impulses of a bounce that leaves the energy of the bodies at
// `most`, J, or less, or at least does not increase it. Contacts are solved one after the other, so a later one may
// otherwise push harder than the body approached.
INLINE Real pair_share(const ContactArms* c, Real most, const Real speed[2], const Real mass[2], Real impulse1,
                       Real impulse2)
{
	Real zero = splat(0.0f), one = splat(1.0f);
	Real slope = speed[0] * impulse1 + speed[1] * impulse2;
	Real yields = quotient(impulse1 * impulse1, blend(one, mass[0], mass[0] > zero)) +
	              quotient(impulse2 * impulse2, blend(one, mass[1], mass[1] > zero)) +
	              2.0f * pair_cross(c) * impulse1 * impulse2;
	Real left = maximum(flush_below(most - pair_energy(c), ABSORBS), zero);
	Int more = (slope + 0.5f * yields > left) & (yields >= splat(ABSORBS));
	// the positive root of yields / 2 part^2 + slope part = left; 0 if the fraction is so small that its square may be
	// a denormal, because impulses may be huge
	Real safe = blend(one, yields, more), down = quotient(slope, safe);
	Real square = down * down + quotient(2.0f * left, safe);
	Int counts = square >= splat(ABSORBS);
	Real part = root(only(square, more & counts)) - down;
	return blend(one, only(minimum(maximum(part, zero), one), counts), more);
}

// Applies restitution to points that will bounce (rebound > 0) and had an impulse in this step. Then clears the
// impulses of these points, because a separating point must not be warm started.
INLINE void pair_bounce(const Pools* p, int i, ContactArms* c, Real gap1, Real gap2, Real mass1, Real mass2,
                        Real* normal1, Real* normal2)
{
	Real zero = splat(0.0f), fall = load(&contact_rare(p, fall, i), 0);
	Real rebound1 = load(&contact_rare(p, rebound1, i), 0), rebound2 = load(&contact_rare(p, rebound2, i), 0);
	Real total1 = load(&contact_rare(p, total_impulse1, i), 0), total2 = load(&contact_rare(p, total_impulse2, i), 0);
	Int hit1 = (rebound1 > zero) & (total1 > zero), hit2 = (rebound2 > zero) & (total2 > zero);
	Real leave1 = bounce_speed(&p->step, rebound1, fall, gap1), leave2 = bounce_speed(&p->step, rebound2, fall, gap2);
	Real speed[2] = {flush_tiny(pair_approach(*c, 0, c->n)), flush_tiny(pair_approach(*c, 1, c->n))};
	Real lack1 = flush_tiny(leave1 - speed[0]), lack2 = flush_tiny(leave2 - speed[1]), mass[2] = {mass1, mass2};
	Real alone1 = only(push_of(mass1 * lack1), hit1);
	Real alone2 = only(push_of(mass2 * lack2), hit2);
	Real impulse1, impulse2;
	pair_joint(c, mass1, mass2, lack1, lack2, &impulse1, &impulse2);
	Int push1 = impulse1 > zero, push2 = impulse2 > zero;
	impulse1 = blend(alone1, push_of(impulse1), hit1 & hit2 & push2);
	impulse2 = blend(alone2, push_of(impulse2), hit1 & hit2 & push1);

	// `most` includes the change of speeds by gravity since the bounce (bounce_speed), which is no gain of energy
	Real more1 = only(leave1 * leave1 - rebound1 * rebound1, hit1),
	     more2 = only(leave2 * leave2 - rebound2 * rebound2, hit2);
	Real most = load(&contact_rare(p, energy, i), 0) + pair_gained(c, more1, more2);
	Real part = pair_share(c, most, speed, mass, impulse1, impulse2);
	impulse1 = push_of(part * impulse1);
	impulse2 = push_of(part * impulse2);
	body_push(&c->a, c->ra[0], &c->b, c->rb[0], vec_scale(impulse1, c->n));
	body_push(&c->a, c->ra[1], &c->b, c->rb[1], vec_scale(impulse2, c->n));
	store(&contact_rare(p, total_impulse1, i), 0, total1 + impulse1);
	store(&contact_rare(p, total_impulse2, i), 0, total2 + impulse2);
	*normal1 = blend(*normal1, zero, hit1);
	*normal2 = blend(*normal2, zero, hit2);
}

// Upper bound of the velocity that warm start gives a point, as a share of max_speed. In a jam between immovable bodies
// impulses add up from step to step, and a body that gets free would leave with all of them: in 20 trials with 300
// bodies at one point and max_speed 400 m/s, the fastest leaves with 104, 92 and 95 m/s for 0.25, 0.2 and 0.15.
#define START_SHARE 0.2f

INLINE Real pair_start(const Step* step, Real impulse, Real mass)
{
	return minimum(impulse, START_SHARE * step->max_speed * mass);
}

INLINE void pair_bias(const Pools* p, int i, const ContactReady* ready, ContactArms* c, Contact* u)
{
	if (p->step.bounces)
		pair_meet(p, i, c, ready->gap[0], ready->gap[1], u->normal_mass1, u->normal_mass2, &u->normal_impulse1,
		          &u->normal_impulse2);
	Real mass[2] = {u->normal_mass1, u->normal_mass2}, impulse[2] = {u->normal_impulse1, u->normal_impulse2};
	pair_normals(p, i, c, ready->gap, mass, 1, ready->gap, impulse);
	u->normal_impulse1 = impulse[0];
	u->normal_impulse2 = impulse[1];
}

// Executes a relax pass. If `held` is null, each gap and mass is computed just before its use: all of them together
// exceed the registers of a CPU, which takes 5 % longer.
INLINE void pair_relax(const Pools* p, int i, const ContactReady* held, ContactArms* c, Contact* u)
{
	Real speed = splat(0.0f), rebound[2] = {splat(0.0f), splat(0.0f)};
	if (p->step.has_rolling)
		speed = load(&contact_rare(p, tangent_speed, i), 0);
	if (p->step.bounces)
	{
		rebound[0] = load(&contact_rare(p, rebound1, i), 0);
		rebound[1] = load(&contact_rare(p, rebound2, i), 0);
	}

	Real gaps[2], masses[2], impulse[2] = {u->normal_impulse1, u->normal_impulse2};
	gaps[0] = held ? held->gap[0] : pair_gap(c, 0, u->separation1);
	gaps[1] = held ? held->gap[1] : pair_gap(c, 1, u->separation2);
	masses[0] = held ? u->normal_mass1 : pair_mass(c, 0, c->n);
	masses[1] = held ? u->normal_mass2 : pair_mass(c, 1, c->n);
	pair_normals(p, i, c, gaps, masses, 0, rebound, impulse);
	u->normal_impulse1 = impulse[0];
	u->normal_impulse2 = impulse[1];

	// friction is limited by impulses of relax: those of bias also push overlaps apart, which causes no friction
	Real mass = held ? u->tangent_mass1 : pair_mass(c, 0, c->t);
	u->tangent_impulse1 =
	    pair_tangent(&p->step, c, 0, mass, speed, u->friction * u->normal_impulse1, u->tangent_impulse1);
	mass = held ? u->tangent_mass2 : pair_mass(c, 1, c->t);
	u->tangent_impulse2 =
	    pair_tangent(&p->step, c, 1, mass, speed, u->friction * u->normal_impulse2, u->tangent_impulse2);
	if (p->step.has_rolling)
		pair_roll(p, i, c, u->normal_impulse1 + u->normal_impulse2);
	if (STEP_RARE(p->step))
		pair_total(p, i, u->normal_impulse1, u->normal_impulse2);
}

// Functions that every kind of constraint has.

// Derives the effective masses that passes (IN_* bits) need; they are constant within a step.
INLINE void contact_derive(int passes, const Body* a, const Body* b, Contact* u)
{
	ContactArms c = pair_of(u, a, b);
	u->normal_mass1 = pair_mass(&c, 0, c.n);
	u->normal_mass2 = pair_mass(&c, 1, c.n);
	if (passes & IN_RELAX)
	{
		u->tangent_mass1 = pair_mass(&c, 0, c.t);
		u->tangent_mass2 = pair_mass(&c, 1, c.t);
	}
}

// Limits the normal impulses of the last step (START_SHARE), which warm start this step.
INLINE void contact_start(const Step* step, Contact* u)
{
	u->normal_impulse1 = pair_start(step, u->normal_impulse1, u->normal_mass1);
	u->normal_impulse2 = pair_start(step, u->normal_impulse2, u->normal_mass2);
}

INLINE void contact_ready(const Pools* p, int pass, int i, const Body* a, const Body* b, const Contact* u,
                          ContactReady* ready)
{
	(void)p;
	(void)pass;
	(void)i;
	ContactArms c = pair_of(u, a, b);
	ready->gap[0] = pair_gap(&c, 0, u->separation1);
	ready->gap[1] = pair_gap(&c, 1, u->separation2);
}

// Executes a pass. held: result of contact_ready after contact_derive, if the caller keeps u in registers; or null.
INLINE void contact_pass(const Pools* p, int pass, int i, const ContactReady* held, Contact* u, Body* a, Body* b)
{
	ContactArms c = pair_of(u, a, b);
	ContactReady ready;
	ready.gap[0] = ready.gap[1] = splat(0.0f);
	if (held)
		ready = *held;
	else if (pass != PASS_RELAX)
	{
		contact_derive(1 << pass, a, b, u);
		if (pass == PASS_WARM_START)
			contact_start(&p->step, u);
		else
			contact_ready(p, pass, i, a, b, u, &ready);
	}
	if (pass == PASS_WARM_START)
		pair_push(p, i, &c, u->normal_impulse1, u->normal_impulse2, u->tangent_impulse1, u->tangent_impulse2);
	else if (pass == PASS_BOUNCE)
		pair_bounce(p, i, &c, ready.gap[0], ready.gap[1], u->normal_mass1, u->normal_mass2, &u->normal_impulse1,
		            &u->normal_impulse2);
	else if (pass == PASS_BIAS)
		pair_bias(p, i, &ready, &c, u);
	else
		pair_relax(p, i, held, &c, u);
	*a = c.a;
	*b = c.b;
}

#endif
