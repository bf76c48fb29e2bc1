// SPDX-License-Identifier: MIT
// narrow_phase.h -- computes manifolds of contacts, transfers impulses to new points, releases parted contacts.
#ifndef NARROW_PHASE_H
#define NARROW_PHASE_H
#include "constraints/contact_one.h"
#include "pools/bays.h"
#include "stages/color/edge.h"
#include "stages/geometry/box.h"
#include "stages/geometry/predicted_manifold.h"
#include "stages/narrow_phase/manifold_reuse.h"

#define MATCH_DISTANCE (2.0f * SPECULATIVE_DISTANCE) // m: maximum distance at which points of different features match

// Returns the index of the old point from which a new point inherits impulses: the point of the same feature, else the
// nearest point within MATCH_DISTANCE, else -1. taken: mask of old points that are already used.
INLINE int narrow_phase_match(int feature, Vec point, int old_count, const int* old_feature, const Vec* old_point,
                              int taken)
{
	// constant indices keep points and impulses in registers
	UNROLL
	for (int k = 0; k < 2; ++k)
		if (k < old_count && old_feature[k] == feature && !(taken & 1 << k))
			return k;
	int best = -1;
	float nearest = MATCH_DISTANCE * MATCH_DISTANCE;
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		Vec d = vec_sub(point, old_point[k]);
		float square = vec_dot(d, d);
		if (k < old_count && !(taken & 1 << k) && square < nearest)
		{
			nearest = square;
			best = k;
		}
	}
	return best;
}

// m: Returns the motion up to which a manifold is kept. gap, room, within: Manifold.gap, sweep_room, sweep_within.
INLINE float narrow_phase_distance(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Word flags, float gap,
                                   float room, float within)
{
	int count = (int)(flags & CONTACT_COUNT);
	if (count == 0)
		return STAY_DISTANCE * room + maximum(gap - within, 0.0f);
	if (flags & CONTACT_DETECTED)
		return STAY_DISTANCE * room;
	float distance = count == 2 || (flags & MANIFOLD_ROLLS) ? HOLD_DISTANCE : 0.5f * HOLD_DISTANCE;
	return minimum(distance * room, HOLD_SHARE * minimum(a->reach, b->reach));
}

// Releases contact i if the boxes of its pair have parted. Returns whether the contact was released.
INLINE int narrow_phase_parted(const Pools* p, int i, Int2 pair)
{
	if (!box_parted(p, pair))
		return 0;
	contact_end(p, i);
	island_wake_parted(p, p->contact_bodies[i], p->contact_flags[i]);
	contact_count(p, p->contact_bodies[i], p->contact_flags[i], -1);
	p->pair[i] = make_int2(-1, -1);
	if (p->step.sleep)
		atomic_add_int(p->contact_group_free + (i >> GROUP_BITS), 1);
	p->contact_flags[i] = 0;
	atomic_add_int(&p->counters->released, 1);
	return 1;
}

#define PLACE_APART CENTERS_APART           // m: bodies whose centers of mass are nearer than this are at one place
#define PLACE_ASIDE (10.0f * CENTERS_APART) // m: maximum component of the offset of a body (narrow_phase_place)

// m: Returns a pseudo-random offset for a body. body: its index within its world. Neighbors in a pool, often created together, get unrelated offsets.
INLINE Vec narrow_phase_place(int body)
{
	Word x = (Word)body * 0x9e3779b9u;
	x ^= x >> 15;
	x *= 0x7feb352du;
	x ^= x >> 16;
	float scale = PLACE_ASIDE / 32768.0f;
	return vec(scale * (float)((int)(x & 65535u) - 32768), scale * (float)((int)(x >> 16) - 32768));
}

// Returns shape b, displaced if both bodies can move and are at one place. If all such pairs had one normal, bodies
// created at a point would leave it in a row, and the speeds of pairs would add up: to 205 m/s for 500 circles.
INLINE WorldShape narrow_phase_apart(const Pools* p, WorldShape a, WorldShape b)
{
	float x = (b.x + b.center_x) - (a.x + a.center_x), y = (b.y + b.center_y) - (a.y + a.center_y);
	if (!(absolute(x) + absolute(y) < PLACE_APART) || !(p->body[a.body].inv_mass > 0.0f) ||
	    !(p->body[b.body].inv_mass > 0.0f))
		return b;
	Vec aside = vec_sub(narrow_phase_place(bay_body(p, b.body)), narrow_phase_place(bay_body(p, a.body)));
	b.x = b.x + aside.x;
	b.y = b.y + aside.y;
	return b;
}

// Returns the manifold of a pair and the poses for which it was computed. answers: 0 if the contact gets no impulses.
// far: not 0 if a collidable is fast. belt: not 0 if a surface has a tangent speed. within, m: maximum separation of
// points. *has_rolling: receives MANIFOLD_* bits if the points follow the corners, else remains unchanged.
INLINE Prediction narrow_phase_find(const Pools* p, WorldShape a, WorldShape b, int answers, int far, int belt,
                                    int moved, float within, Word* has_rolling)
{
	// computed in the frame of shape a, so that the result does not depend on the distance from the origin
	Vec turn = vec(a.c, a.s);
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Prediction found_at;
	found_at.f = frame_at(vec_turn_back(turn, vec(b.x - a.x, b.y - a.y)), vec_turn_back(turn, vec(b.c, b.s)));
	found_at.axes = turn;
	found_at.ahead = 0;
	Closing closing;
	closing.most = 0.0f;
	closing.within = within;
	if (far)
		closing = sweep_closing(p, a, b, moved);
	int meets = closing.most > within;
	if (meets)
	{
		found_at = predict_meeting(p, a, b, closing, found_at);
		if (found_at.ahead != PREDICT_MEETS || !predict_rolls(p, a, b))
			return found_at;
	}
	else
	{
		found_at.m = collide(shape_a, shape_b, found_at.f, reach_of(closing.within));
		if (!answers || found_at.m.count == 0)
			return found_at;
		if (!far)
			closing = sweep_closing(p, a, b, moved);
		found_at = predict_past(p, a, b, closing, found_at);
		int round = shape_a->radius + shape_b->radius > 0.0f;
		if (!found_at.ahead && round)
			*has_rolling = MANIFOLD_ROLLS | (Word)found_at.m.made;
		if (found_at.ahead || round || !belt)
			return found_at;
	}
	return predict_end(p, a, b, closing, found_at, meets);
}

// Transfers to each new point the impulses of its old point, or 0 without one. Returns the features of the new points.
INLINE Int2 narrow_phase_inherit(const Pools* p, int i, Word flags, const Manifold* m)
{
	int old_count = (int)(flags & CONTACT_COUNT), constraint = p->contact_place[i];
	Int2 features = p->contact_feature[i];
	Float4 on_a = p->contact_manifold[i].on_a;
	int old_feature[2] = {features.x, features.y};
	Vec old_point[2] = {vec(on_a.x, on_a.y), vec(on_a.z, on_a.w)};
	float normal[2] = {0.0f, 0.0f}, tangent[2] = {0.0f, 0.0f};
	if (constraint >= 0)
	{
		normal[0] = contact_row(p, normal_impulse1, constraint);
		normal[1] = contact_row(p, normal_impulse2, constraint);
		tangent[0] = contact_row(p, tangent_impulse1, constraint);
		tangent[1] = contact_row(p, tangent_impulse2, constraint);
	}

	int sleeps = flags & CONTACT_ASLEEP ? 1 : 0;
	if (sleeps)
	{
		normal[0] = p->contact_kept[i].normal_impulse1;
		normal[1] = p->contact_kept[i].normal_impulse2;
		tangent[0] = p->contact_kept[i].tangent_impulse1;
		tangent[1] = p->contact_kept[i].tangent_impulse2;
	}

	float along[2] = {0.0f, 0.0f}, across[2] = {0.0f, 0.0f};
	int feature[2] = {-1, -1}, taken = 0;
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		if (k >= m->count)
			continue;
		feature[k] = m->feature[k];
		int old = narrow_phase_match(feature[k], m->point[k], old_count, old_feature, old_point, taken);
		if (old >= 0)
		{
			taken |= 1 << old;
			along[k] = old ? normal[1] : normal[0];
			across[k] = old ? tangent[1] : tangent[0];
		}
	}
	if (constraint >= 0)
	{
		contact_row(p, normal_impulse1, constraint) = along[0];
		contact_row(p, normal_impulse2, constraint) = along[1];
		contact_row(p, tangent_impulse1, constraint) = across[0];
		contact_row(p, tangent_impulse2, constraint) = across[1];
	}
	if (sleeps)
	{
		p->contact_kept[i].normal_impulse1 = along[0];
		p->contact_kept[i].normal_impulse2 = along[1];
		p->contact_kept[i].tangent_impulse1 = across[0];
		p->contact_kept[i].tangent_impulse2 = across[1];
	}
	return make_int2(feature[0], feature[1]);
}

// Writes a manifold. flags: new flags of the contact.
INLINE void narrow_phase_write(const Pools* p, int i, Word flags, const Prediction* at, int shape_a, int shape_b,
                               int moved, float within)
{
	const Manifold* m = &at->m;
	const GLOBAL Attribute *a = p->attribute + shape_a, *b = p->attribute + shape_b;
	LocalManifold manifold;
	manifold.normal = make_float4(m->normal.x, m->normal.y, m->separation[0], m->separation[1]);
	manifold.on_a = make_float4(m->point[0].x, m->point[0].y, m->point[1].x, m->point[1].y);
	manifold.relative = make_float4(at->f.position.x, at->f.position.y, at->f.rotation.x, at->f.rotation.y);
	manifold.then = make_float4(
	    at->axes.x, at->axes.y, a->reach,
	    at->ahead ? -1.0f : narrow_phase_distance(a, b, flags, m->gap, sweep_room(&p->step, moved), within));
	p->contact_manifold[i] = manifold;
}

// Completes a new manifold of a contact of which a body sleeps, or slept before this step. A body wakes if it begins to
// touch an awake body or a collidable that moves, and if a touch of it ends. contact_sleep begins the constraint when
// both bodies are awake. flags: flags of the contact before this step. moved: COLLIDABLE_* bits of the pair.
RARE int narrow_phase_asleep(const Pools* p, int i, Word flags, int moved)
{
	Int2 bodies = p->contact_bodies[i];
	int a = body_island(p, bodies.x), b = body_island(p, bodies.y);
	int fixed = !(p->body[bodies.x].inv_mass > 0.0f) || !(p->body[bodies.y].inv_mass > 0.0f);
	if (!(p->contact_flags[i] & CONTACT_TOUCHING))
	{
		p->contact_flags[i] &= ~CONTACT_ASLEEP;
		contact_end(p, i);
		if (flags & CONTACT_ASLEEP)
			contact_forget(p, i);
		island_wake_parted(p, bodies, flags);
		return EDGE_NONE;
	}
	if (flags & (CONTACT_DETECTED | CONTACT_PENDING))
		return EDGE_NONE;
	if (fixed ? moved & COLLIDABLE_SHIFTED : a < 0 || b < 0)
		island_wake_both(p, bodies);
	else if (!fixed && a != b)
	{
		raise_int(&p->counters->joined_islands, 1);
		if (BATCHED(p))
			raise_int(&bay_of_contact(p, i)->joined_islands, 1);
	}
	if (!(flags & CONTACT_TOUCHING))
		p->contact_press[i] = 0;
	p->contact_flags[i] |= CONTACT_ASLEEP;
	if (flags & CONTACT_TOUCHING || p->contact_color[i] != COLOR_NONE)
		return EDGE_NONE;
	p->contact_color[i] = COLOR_WANTED;
	raise_int(&p->counters->changed, 1);
	return edge_of(CONSTRAINT_CONTACT, i);
}

// Returns the contact as an edge if it must be listed, else EDGE_NONE.
RARE int narrow_phase_look(const Pools* p, int i, Word flags)
{
	Int2 pair = p->pair[i];
	int moved = p->collidable_flags[pair.x] | p->collidable_flags[pair.y];
	if (!(flags & CONTACT_FRESH) && (moved & COLLIDABLE_NEW_BOX) && narrow_phase_parted(p, i, pair))
		return EDGE_NONE;
	if (flags & CONTACT_APART)
	{
		p->contact_flags[i] = flags & (CONTACT_APART | CONTACT_LASTS);
		return EDGE_NONE;
	}
	if (!(flags & CONTACT_ANEW))
	{
		p->contact_flags[i] = flags & ~CONTACT_LOOK;
		return EDGE_NONE;
	}

	WorldShape a = p->world_shape[pair.x], b = p->world_shape[pair.y];
	Word has_rolling = 0;
	int answers = !(flags & CONTACT_DETECTED), far = answers && (moved & COLLIDABLE_FAST);
	int belt = edge_belt_of(p, CONSTRAINT_CONTACT, i);
	if (answers)
		b = narrow_phase_apart(p, a, b);
	float within = sweep_within(p, moved, a.body);
	Prediction at = narrow_phase_find(p, a, b, answers, far, belt, moved, within, &has_rolling);
	Int2 features = narrow_phase_inherit(p, i, flags, &at.m);
	Word touching = at.m.count > 0 ? CONTACT_TOUCHING : 0u;
	Word overlaps = minimum(at.m.separation[0], at.m.separation[1]) < 0.0f ? MANIFOLD_OVERLAPS : 0u;
	Word now = (flags & CONTACT_LASTS) | touching | (Word)at.m.count | has_rolling | overlaps;
	p->contact_flags[i] = now;
	p->contact_feature[i] = features;
	narrow_phase_write(p, i, now, &at, a.attribute, b.attribute, moved, within);
	Int2 bodies = p->contact_bodies[i];
	if (p->step.sleep && (flags & CONTACT_ASLEEP || p->sleep[bodies.x] | p->sleep[bodies.y]))
		return narrow_phase_asleep(p, i, flags, moved);
	if (!touching)
	{
		contact_end(p, i);
		island_wake_parted(p, bodies, flags);
		return EDGE_NONE;
	}
	if (flags & (CONTACT_TOUCHING | CONTACT_DETECTED | CONTACT_PENDING))
		return EDGE_NONE;
	p->contact_press[i] = 0; // clears the presses that the contact handed on when it last touched
	return edge_begin(p, edge_of(CONSTRAINT_CONTACT, i), bodies);
}

// prefetch distance, in contacts; a prefetch helps because the members of a pair are anywhere in the pools. Contacts of
// another worker's chunk are not prefetched, because that worker changes their flags at the same time.
#define NARROW_PHASE_SOON 12

LIST_KERNEL(narrow_phase, began, began)
{
	i = active_item(p, GROUPS_OF_CONTACTS, i);
	int soon = i + NARROW_PHASE_SOON;
	if (FETCHES && p->step.collidables >= FETCH_COLLIDABLES && soon < p->counters->live &&
	    soon / CHUNK_ITEMS == i / CHUNK_ITEMS && p->contact_flags[soon] & CONTACT_LOOK)
	{
		Int2 pair = p->pair[soon], bodies = p->contact_bodies[soon];
		fetch_soon(p->world_shape + pair.x);
		fetch_soon(p->world_shape + pair.y);
		fetch_soon(p->box + pair.x);
		fetch_soon(p->box + pair.y);
		fetch_soon(p->old_box + pair.x);
		fetch_soon(p->old_box + pair.y);
		fetch_soon(p->body + bodies.x);
		fetch_soon(p->body + bodies.y);
		int constraint = p->contact_place[soon];
		if (constraint >= 0)
		{
			fetch_soon(&contact_row(p, normal_impulse1, constraint));
			fetch_soon(&contact_row(p, normal_impulse2, constraint));
			fetch_soon(&contact_row(p, tangent_impulse1, constraint));
			fetch_soon(&contact_row(p, tangent_impulse2, constraint));
		}
	}
	Word flags = p->contact_flags[i];
	return flags & CONTACT_LOOK ? narrow_phase_look(p, i, flags) : EDGE_NONE;
}

#endif
