// SPDX-License-Identifier: MIT
// manifold_reuse.h -- selects the contacts that keep their manifold, and marks the others for narrow_phase.
// If the collidables of a pair have hardly moved relative to each other, as in a settled pile, the points keep their
// places on both collidables, and nothing is written (contact_points.h computes the points). If the pair rotates
// together, as in a drum, normal and arms rotate with the pair: only the rotation is written.
#ifndef MANIFOLD_REUSE_H
#define MANIFOLD_REUSE_H
#include "constraints/constraint_kinds.h"
#include "constraints/sweep_closing.h"
#include "stages/edit/active.h"

// cosine of 3.6 degrees: a manifold with points is kept until a collidable has rotated by more than this angle; each
// manifold is kept only until a point has moved by narrow_phase_distance
#define HOLD_COSINE 0.998f

// Limits of the motion of a point up to which a manifold is kept. HOLD_DISTANCE, m: halved for a single point that does
// not roll, so that no second point is missed. HOLD_SHARE: fraction of the smaller collidable's reach. With smaller
// limits heaps shake: each new manifold pushes a small body that carries many others in another direction.
#define HOLD_DISTANCE (2.0f * SPECULATIVE_DISTANCE)
#define HOLD_SHARE    0.1f

// m: a pair without points is tested again when a point has moved by more than this plus the amount by which the pair's
// gap exceeds the speculative distance. It is a quarter of the speculative distance, so that no contact is missed.
#define STAY_DISTANCE LINEAR_SLOP

#define TURN_SHARE 0.3f // fraction of narrow_phase_distance up to which a pair that rotates together keeps its points

// Returns an upper bound of the distance that any point of shape b within the reach of shape a has moved since shape b
// had the pose (position, rotation). All poses are in the frame of shape a. The bound is the motion of the point at the
// origin of that frame, plus the reach of shape a times the rotation. A length is bounded by the sum of its components.
INLINE Real narrow_phase_moved(Vec position, Vec rotation, Vec position_now, Vec rotation_now, Real reach)
{
	Vec turn = vec_turn_back(rotation, rotation_now);
	Vec moved = vec_sub(position_now, vec_turn(turn, position));
	return absolute(moved.x) + absolute(moved.y) + reach * (absolute(turn.y) + absolute(1.0f - turn.x));
}

// Returns the relative motion of the collidables of a pair. a, b: the rows of shapes a and b in the pool world_shape.
INLINE Closing narrow_phase_closing(const Pools* p, int i, const Real a[8], const Real b[8])
{
	Int ia, ib;
	load_int2(p->contact_bodies, i, &ia, &ib);
	Int shape_a = real_bits(a[6]), shape_b = real_bits(b[6]);
	Real body_a[8], body_b[8];
	gather_fixed_rows8((GLOBAL float*)p->body, ia, body_a);
	gather_fixed_rows8((GLOBAL float*)p->body, ib, body_b);
	const GLOBAL float *radius = &p->attribute->radius, *reach = &p->attribute->reach;
	Sweep sweep_a = sweep_with(sweep_advance_of(&p->step, vec(body_a[0], body_a[1]), body_a[2]), vec(a[4], a[5]),
	                           sweep_shape(reach, shape_a) - sweep_shape(radius, shape_a));
	Sweep sweep_b = sweep_with(sweep_advance_of(&p->step, vec(body_b[0], body_b[1]), body_b[2]), vec(b[4], b[5]),
	                           sweep_shape(reach, shape_b) - sweep_shape(radius, shape_b));
	return sweep_apart(vec(b[0] - a[0], b[1] - a[1]), sweep_a, sweep_b);
}

// Returns the lanes in which an impulse of the last step pushed the pair apart.
INLINE Int narrow_phase_loaded(const Pools* p, int i)
{
	Int c = load_int(p->contact_place, i), there = c >= 0;
	c = c & ~(c >> 31);
	Int at = c / MAX_LANES * (int)(sizeof(ContactRows) / sizeof(float)) + c % MAX_LANES;
	Real zero = splat(0.0f);
	Real load1 = gather((const GLOBAL float*)p->contact_rows->normal_impulse1, at),
	     load2 = gather((const GLOBAL float*)p->contact_rows->normal_impulse2, at);
	return there & ((load1 > zero) | (load2 > zero));
}

#define KEEP_SOON 32 // prefetch distance, in contacts

INLINE void narrow_phase_keep_fetch(const Pools* p, int i, int live)
{
	int soon = FETCHES && p->step.collidables >= FETCH_COLLIDABLES ? i + KEEP_SOON + LANES : 0;
	for (int k = i + KEEP_SOON; k < soon && k < live; ++k)
	{
		Int2 pair = p->pair[k], bodies = p->contact_bodies[k];
		fetch_soon(p->world_shape + (pair.x & ~(pair.x >> 31)));
		fetch_soon(p->world_shape + (pair.y & ~(pair.y >> 31)));
		fetch_soon(p->body + bodies.x);
		fetch_soon(p->body + bodies.y);
	}
}

typedef struct // LANES contacts, and the motion of their collidables since their manifolds were computed
{
	Real a[8], b[8];   // rows of shapes a and b in the pool world_shape
	Int far, on;       // masks: a collidable has COLLIDABLE_FAST; one has COLLIDABLE_MOVING, and there are points
	Vec then_a;        // rotation of shape a when the manifold was computed
	Real shift, limit; // m: motion since then; largest motion up to which the manifold is kept
	Real room;         // factor of the pair's tolerances along its surfaces, and of its speculative distance
} ManifoldReuse;

// Returns the lanes whose manifold could be kept but is computed again, because the pair may meet, or moves too far,
// within the step. In other lanes whose pairs rotate together, stores the current rotation of shape a in the manifold.
// wanders: lanes to test.
INLINE Word narrow_phase_wander(const Pools* p, int i, Int flags, Word wanders, const ManifoldReuse* c)
{
	Real at[8];
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * indices(i), at);
	Closing closing = narrow_phase_closing(p, i, c->a, c->b);
	Int touches = ((flags & (int)MANIFOLD_OVERLAPS) != 0) | narrow_phase_loaded(p, i);

	// an approach that cannot close the gap in the step gets no impulse
	Real limit = maximum(blend(SWEEP_REST * c->room, SWEEP_SLOP * c->room, touches),
	                     quotient(minimum(at[2], at[3]) - c->shift, splat(sweep_end(&p->step))));
	Real turns = absolute(closing.a.turn) + absolute(closing.b.turn);
	Real slide = absolute(vec_cross(vec_turn(c->then_a, vec(at[0], at[1])), closing.near));
	Int lags = touches & (slide + turns * minimum(closing.a.reach, closing.b.reach) > SWEEP_LAG * c->room);
	Int in_place = (slide <= SWEEP_LAG * c->room) & (c->shift <= splat(TURN_SHARE) * c->limit);
	Int passes = c->on & (((closing.most < limit) == 0) | (lags & (in_place == 0)));
	Word anew = wanders &
	            lane_bits(passes | (c->far & ((closing.most > splat(SPECULATIVE_DISTANCE)) | (c->room < splat(1.0f)))));

	Word along = wanders & ~anew & lane_bits(c->on & lags);
	for (int k = 0; along >> k != 0; ++k)
	{
		if (!(along >> k & 1))
			continue;
		WorldShape now = p->world_shape[p->pair[i + k].x];
		Float4 then = p->contact_manifold[i + k].then;
		p->contact_manifold[i + k].then = make_float4(now.c, now.s, then.z, then.w);
	}
	return anew;
}

// Marks the contacts that narrow_phase processes: those that are new, have moved too far since their manifold was
// computed, may meet or move too far within the step, or have a collidable with a new box.
WIDE_KERNEL(narrow_phase_keep)
{
	int live = p->counters->live;
	i = active_item(p, GROUPS_OF_CONTACTS, i);
	narrow_phase_keep_fetch(p, i, live);
	Int flags = load_int(p->contact_flags, i), ia, ib;
	load_int2(p->pair, i, &ia, &ib);
	Word there = lane_bits((ia >= 0) & (indices(i) < live)), apart = lane_bits((flags & (int)CONTACT_APART) != 0);
	if (there == 0)
		return;
	ia = ia & ~(ia >> 31);
	ib = ib & ~(ib >> 31);
	Int moved = gather_int(p->collidable_flags, ia) | gather_int(p->collidable_flags, ib);
	ManifoldReuse c;
	Real manifold[8];
	gather_fixed_rows8((GLOBAL float*)p->world_shape, ia, c.a);
	gather_fixed_rows8((GLOBAL float*)p->world_shape, ib, c.b);
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * indices(i) + 1, manifold);

	Vec axes_a = vec(c.a[2], c.a[3]), axes_b = vec(c.b[2], c.b[3]);
	c.then_a = vec(manifold[4], manifold[5]);
	Vec turn = vec(manifold[2], manifold[3]), then_b = vec_turn(c.then_a, turn);
	c.shift = narrow_phase_moved(vec(manifold[0], manifold[1]), turn,
	                             vec_turn_back(axes_a, vec(c.b[0] - c.a[0], c.b[1] - c.a[1])),
	                             vec_turn_back(axes_a, axes_b), manifold[6]);
	c.limit = manifold[7];
	Int points = (flags & (int)CONTACT_COUNT) != 0;
	Real cosine = minimum(vec_dot(c.then_a, axes_a), vec_dot(then_b, axes_b));
	Int upright = cosine >= splat(HOLD_COSINE);
	Word stays = lane_bits((c.shift < c.limit) & (upright | (points == 0)) & ((flags & (int)CONTACT_FRESH) == 0));
	Word anew = there & ~stays & ~apart;

	Int answers = (flags & (int)CONTACT_DETECTED) == 0;
	c.room = sweep_room(&p->step, moved);
	c.far = (moved & COLLIDABLE_FAST) != 0;
	c.on = ((moved & COLLIDABLE_MOVING) != 0) & points;
	Word wanders = there & stays & ~apart & lane_bits(answers & (c.far | c.on));
	if (wanders)
		anew |= narrow_phase_wander(p, i, flags, wanders, &c);
	Word look = anew | (there & (lane_bits((moved & COLLIDABLE_NEW_BOX) != 0) |
	                             (apart & lane_bits((flags & (int)CONTACT_FRESH) != 0))));
	if (look == 0)
		return;
	raise_int(&p->counters->look, p->step.sleep ? p->counters->active_items[GROUPS_OF_CONTACTS] : live);
	for (int k = 0; look >> k != 0; ++k)
		if (look >> k & 1)
			p->contact_flags[i + k] |= anew >> k & 1 ? CONTACT_LOOK | CONTACT_ANEW : CONTACT_LOOK;
}

#endif
