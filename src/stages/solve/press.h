// SPDX-License-Identifier: MIT
// press.h -- finds bodies that something kinematic presses against something static, directly or through others.
//
// A body may overlap a static one because something kinematic presses it there, which no force can stop, or because a
// load rests on it. The contacts of the body do not distinguish these two cases. So each press is propagated as a way:
// a direction, with a number of hops left. A body that overlaps something kinematic is pressed along the normal, and
// presses the bodies that it touches in about that direction, and so on: contacts hand ways on. The number begins at
// PRESS_HOPS and is reduced by each hop, so that a way fades when its source is gone. Static bodies start ways too,
// away from themselves. A body with ways of both kinds is pressed between the two. A contact stores its hops between
// steps; bodies collect their ways again in each step.
#ifndef PRESS_H
#define PRESS_H
#include "constraints/contact_report_points.h"
#include "constraints/joint_prepare.h"
#include "pools/bays.h"
#include "stages/geometry/sweep.h"

// minimum cosine between a way and the normal of a contact that hands the way on; with a smaller minimum, a box that is
// pushed along a floor would hand the way on to the floor
#define PRESS_ALONG 0.15f

#define PRESS_HOPS   63   // maximum number of hops of a way, and so of bodies in a row through which a press acts
#define PRESS_STEPS  32   // number of steps after a press in which the speed of the body is limited
#define PRESS_SLOWER 0.9f // fraction of its speed that a pressed body may keep per step if it is faster than the press

// Way of kind 0 (static) or 1 (kinematic) in the pool contact_press: 6 bits of hops; PRESS_BACK: it leads from b to a.
#define PRESS_WAY(bits, kind) ((int)(127u & ((bits) >> 7 * (kind))))
#define PRESS_BACK            64

#define PRESS_SPEED 16 // first bit of the press's speed, behind both ways: the upper bits of a float, rounded up

INLINE float press_speed(Word bits) { return bits_float((int)(bits >> PRESS_SPEED << 15)); }

// speed: bits of a float. The caller chooses among integers: LLVM 18, as PoCL 6 calls it, aborts at a choice of floats.
INLINE Word press_bits(const int way[2], int speed)
{
	Word bits = (Word)way[0] | (Word)way[1] << 7;
	return way[1] ? bits | (((Word)speed + 32767u) >> 15 << PRESS_SPEED) : bits;
}

// Returns the code of a way of a body: hops, and direction in units of 1/127. The largest code of a body wins, so
// between ways with equal hops the choice is arbitrary, but the same on every device.
INLINE int press_code(int hops, Vec direction)
{
	int x = (int)(127.0f * direction.x + 128.5f), y = (int)(127.0f * direction.y + 128.5f);
	return hops << 16 | x << 8 | y;
}

INLINE Vec press_direction(int code) { return vec((float)(code >> 8 & 255) - 128.0f, (float)(code & 255) - 128.0f); }

// Returns the number of hops left after a contact with this normal has handed a way on, 0 if the way ends there.
INLINE int press_left(int code, Vec normal)
{
	int along = vec_dot(press_direction(code), normal) > PRESS_ALONG * 127.0f;
	return along && code >> 16 > 1 ? (code >> 16) - 1 : 0;
}

// Returns whether a kernel must do nothing: it was started before the host read the counters, and the layout changed.
INLINE int press_waits(const Pools* p) { return (p->argument & PRESS_MAY_WAIT) && !p->counters->kept; }

// Returns whether nothing may press bodies in a world of a batch. state: of the world; not read outside of a batch.
INLINE int press_rests(const Pools* p, const GLOBAL BayState* state) { return BATCHED(p) && !state->presses; }

// Returns the slot of the contact at place i; -1 if there is none, or if the kernel must do nothing (press_waits). The host may not
// have read the layout of a batch yet.
INLINE int press_slot(const Pools* p, int i)
{
	if (BATCHED(p) && i >= p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS + 1])
		return -1;
	int slot = press_waits(p) ? -1 : p->contact_place_slot[i];
	return slot >= 0 && press_rests(p, bay_of_contact(p, slot)) ? -1 : slot;
}

RARE ContactPoints press_points(const Pools* p, int slot)
{
	Int2 pair = p->pair[slot];
	float a[8], b[8], manifold[16];
	load_rows8((GLOBAL float*)(p->world_shape + pair.x), 0, a);
	load_rows8((GLOBAL float*)(p->world_shape + pair.y), 0, b);
	load_rows8((GLOBAL float*)(p->contact_manifold + slot), 0, manifold);
	load_rows8((GLOBAL float*)(p->contact_manifold + slot), 1, manifold + 8);
	return contact_report_points(p->attribute, a, b, manifold, p->contact_flags[slot], p->contact_feature[slot]);
}

typedef struct // data of a contact that all rounds use
{
	Vec normal;
	float gap; // m: smaller separation of the two points
} PressContact;

#define PRESS_NONE 2.0f // value of normal_x for a contact whose data is not computed yet

// Stores data of the contact at place i in rows that are free until the solve prepares them. Returns the data.
INLINE PressContact press_keep(const Pools* p, int i, const ContactPoints* at)
{
	PressContact facts;
	facts.normal = at->normal;
	facts.gap = minimum(at->separation[0], at->separation[1]);
	contact_row(p, normal_x, i) = facts.normal.x;
	contact_row(p, normal_y, i) = facts.normal.y;
	contact_row(p, separation1, i) = facts.gap;
	return facts;
}

// Returns the data of the contact in `slot`, at place i, and computes it at the first use.
INLINE PressContact press_facts(const Pools* p, int i, int slot)
{
	PressContact facts;
	facts.normal = vec(contact_row(p, normal_x, i), contact_row(p, normal_y, i));
	facts.gap = contact_row(p, separation1, i);
	if (facts.normal.x == PRESS_NONE)
	{
		ContactPoints at = press_points(p, slot);
		facts = press_keep(p, i, &at);
	}
	return facts;
}

// m/s: Returns the largest speed, up to max_speed, of a kinematic body at overlapping points where it approaches.
INLINE float press_pushes(const Pools* p, int i, ContactPoints at)
{
	WorldShape a = p->world_shape[p->pair[i].x], b = p->world_shape[p->pair[i].y];
	BodyState body = p->body[b.body];
	Vec from = vec(a.x - b.x - b.center_x, a.y - b.y - b.center_y);
	float most = 0.0f;
	for (int k = 0; k < 2; ++k)
	{
		Vec v = vec_add(vec(body.vx, body.vy), vec_spin(body.w, vec_add(from, at.point[k])));
		if (at.separation[k] < 0.0f && vec_dot(v, at.normal) < 0.0f)
			most = maximum(most, vec_dot(v, v));
	}
	return minimum(square_root(most), p->step.max_speed);
}

INLINE void press_give(const Pools* p, int body, int kind, int hops, Vec direction)
{
	float square = vec_dot(direction, direction);
	if (square > 0.5f && square < 2.0f)
		raise_int(&p->press[body].way[kind], press_code(hops, direction));
}

// Clears the ways and depth of body i, and stores its speed and spin at the start of the step.
KERNEL(press_begin)
{
	BodyState state = p->body[i];
	Vec v = vec(state.vx, state.vy);
	if (press_waits(p) || !(state.inv_mass > 0.0f) || press_rests(p, bay_state_of(p, i)))
		return;
	GLOBAL Press* press = p->press + i;
	press->way[0] = 0;
	press->way[1] = 0;
	press->depth = 0;
	press->tight = 0;
	press->before = minimum(square_root(number_of(vec_dot(v, v))), p->step.max_speed);
	press->spun = minimum(absolute(number_of(state.w)), p->step.max_spin);
}

// Starts a way at an overlap with a static or kinematic body. lasts: 1 while the speed of the pressed body is limited.
RARE void press_start(const Pools* p, int i, int slot, int lasts)
{
	ContactPoints at = press_points(p, slot);
	PressContact facts = press_keep(p, i, &at);
	int body = contact_row(p, body_a, i), kinematic = p->collidable_kind[p->contact_place_pair[i].y] == KIND_KINEMATIC;
	if (lasts && facts.gap < -PRESS_MOST)
		raise_int(&p->press[body].tight, 1);
	if (!(facts.gap < -PRESS_FROM))
		return;
	press_give(p, body, kinematic, PRESS_HOPS, vec_neg(facts.normal));
	if (kinematic)
		raise_int(&p->press[body].speed, float_bits(press_pushes(p, slot, at)));
}

// Item: a place of contacts. Gives ways in a contact to the bodies to which they lead; starts one at an immovable body.
KERNEL(press_gather)
{
	int slot = press_slot(p, i);
	if (slot < 0)
		return;
	Word bits = p->contact_press[slot];
	int first = !(p->argument & PRESS_AGAIN);
	// a contact without ways has nothing to give, or it started its way at an immovable body in the first round
	if (!first && bits == 0)
		return;
	int still = p->collidable_kind[p->contact_place_pair[i].y] < KIND_DYNAMIC;
	int body_a = contact_row(p, body_a, i), body_b = contact_row(p, body_b, i), lasts = 0;
	if (first)
	{
		contact_row(p, normal_x, i) = PRESS_NONE;
		lasts = p->press[body_a].left > 0 || (!still && p->press[body_b].left > 0);
	}
	if (still)
	{
		press_start(p, i, slot, lasts);
		return;
	}
	if (bits == 0 && !lasts)
		return;
	PressContact facts = press_facts(p, i, slot);
	if (lasts && facts.gap < -PRESS_MOST)
	{
		raise_int(&p->press[body_a].tight, 1);
		raise_int(&p->press[body_b].tight, 1);
	}
	if (!(facts.gap < 0.0f))
		return;
	for (int k = 0; k < 2; ++k)
	{
		int way = PRESS_WAY(bits, k), back = way & PRESS_BACK;
		if (way == 0)
			continue;
		press_give(p, back ? body_a : body_b, k, way & (PRESS_BACK - 1), back ? vec_neg(facts.normal) : facts.normal);
		if (k)
			raise_int(&p->press[back ? body_a : body_b].speed, float_bits(press_speed(bits)));
	}
}

#define PRESS_HOLDS(k) (JOINT_LOCKED(k) | JOINT_SPRING(k)) // modes that hold the anchors together along coordinate k

// Item: a joint. If one body cannot move and the anchors are far apart, starts a way, like a press with max_speed.
KERNEL(press_joint)
{
	int ia = p->joint_data[i].body_a, ib = p->joint_data[i].body_b, modes = (int)p->joint_data[i].modes;
	if (press_waits(p) || press_rests(p, bay_of_joint(p, i)) ||
	    (p->joint_flags[i] & (JOINT_ACTIVE | JOINT_ACTS)) != (JOINT_ACTIVE | JOINT_ACTS) ||
	    modes & (JOINT_RADIAL | JOINT_COUPLED | JOINT_RAILED) || !(modes & PRESS_HOLDS(JOINT_ALONG)) ||
	    !(modes & PRESS_HOLDS(JOINT_ACROSS)))
		return;
	int still_a = !(p->body[ia].inv_mass > 0.0f), still_b = !(p->body[ib].inv_mass > 0.0f);
	if (still_a == still_b)
		return;
	JointFrame a = joint_frame(p, i, JOINT_AT_FRAME(0), ia, vec(0.0f, 0.0f));
	JointFrame b = joint_frame(p, i, JOINT_AT_FRAME(1), ib, vec(0.0f, 0.0f));
	Vec gap = joint_gap(&a, &b);
	float far = square_root(vec_dot(gap, gap));
	if (!(far > PRESS_GAP && far < MOST_FLOAT))
		return;
	press_give(p, still_a ? ib : ia, 1, PRESS_HOPS,
	           vec_scale(still_a ? quotient(-1.0f, far) : quotient(1.0f, far), gap));
	raise_int(&p->press[still_a ? ib : ia].speed, float_bits(p->step.max_speed));
}

typedef struct // members of Press that press_hand_on reads; other work-items may raise `depth` at that time
{
	int way[2], speed, left;
} PressWays;

INLINE PressWays press_ways(const Pools* p, int body)
{
	const GLOBAL Press* press = p->press + body;
	PressWays ways;
	ways.way[0] = press->way[0];
	ways.way[1] = press->way[1];
	ways.speed = press->speed;
	ways.left = press->left;
	return ways;
}

// Item: a place of contacts. Hands ways on; stores depths of pressed bodies in static ones, for continuous collision.
KERNEL(press_hand_on)
{
	int slot = press_slot(p, i), way[2] = {0, 0};
	if (slot < 0)
		return;
	int body_a = contact_row(p, body_a, i), body_b = contact_row(p, body_b, i), speed = 0;
	int kind = p->collidable_kind[p->contact_place_pair[i].y];
	PressWays a = press_ways(p, body_a), b = a;
	b.way[0] = b.way[1] = 0;
	if (kind == KIND_DYNAMIC)
		b = press_ways(p, body_b);
	int gives = kind == KIND_DYNAMIC ? a.way[0] | a.way[1] | b.way[0] | b.way[1] : a.way[1] | a.left;
	if (gives != 0 && kind != KIND_KINEMATIC)
	{
		PressContact facts = press_facts(p, i, slot);
		for (int k = 0; k < 2 && facts.gap < 0.0f; ++k)
		{
			int to = press_left(a.way[k], facts.normal), back = press_left(b.way[k], vec_neg(facts.normal));
			way[k] = back > to ? back | PRESS_BACK : to;
			speed = k && way[k] ? (back > to ? b.speed : a.speed) : speed;
		}
		if (kind == KIND_STATIC && facts.gap < 0.0f && (way[1] > 0 || a.left > 0))
			raise_int(&p->press[body_a].depth, float_bits(-facts.gap));
		if (kind == KIND_STATIC)
			way[0] = way[1] = 0;
	}
	Word bits = press_bits(way, speed);
	if (bits != p->contact_press[slot])
		p->contact_press[slot] = bits;
	if (way[1])
	{
		raise_int(&p->counters->ways, 1);
		if (BATCHED(p))
			raise_int(&bay_of_contact(p, slot)->ways, 1);
	}
}

#endif
