// SPDX-License-Identifier: MIT
// continuous.h -- a body that the solver would move through something stops inside its surface.
//
// A contact is made before bodies meet, by the velocities at the beginning of a step (sweep.h). A body that is struck or
// turned within the step goes elsewhere, where it may have no contact, or none at the corner that it turns to. So the path of a body that
// went further than a share of its thickness is swept against the collidables along it. The body moves along its path until it is a
// little inside the surface. Its velocity stays, and the next step has a contact for it.
//
// Static collidables stop it by its own displacement alone. Dynamic ones move in the same time by theirs, and of two only those stop that
// go towards the other one where they meet: what goes away must go on, or it would be run through. Something kinematic does not yield: what
// goes towards it keeps up with it from there on. No order matters, as all that is read is from before.
//
// Such bodies are few, and the work per body is long: finalize lists them for a stage of their own. Within finalize it
// used registers for all bodies of a GPU: 1M in motion took 0.159 ms instead of 0.043 ms on an H200. Several work-items
// share a body of many collidables.
//
// This work is based on:
// Erin Catto, Continuous Collision, GDC 2013: static shapes stop moving ones, at a target inside the surface.
#ifndef CONTINUOUS_H
#define CONTINUOUS_H
#include "stages/finalize/continuous_search.h"

// share of the thickness: a path that leaves the box of the step by more is swept against what moves and has no contact
#define CONTINUOUS_OUTLIER 0.5f

// The way of collidable i with its body's displacement.
INLINE ContinuousPath continuous_path(const Pools* p, int i, int pressed, Vec path, float turn)
{
	ContinuousPath g;
	Advance advance;
	advance.path = path;
	advance.turn = turn;
	g.index = i;
	g.pressed = pressed;
	g.from = p->world_shape[i];
	g.filter = p->filter[i];
	g.thickness = p->thickness[g.from.attribute];
	g.way = continuous_way(p, g.from, advance);
	g.swing = absolute(turn) * g.way.reach;
	return g;
}

// The box around a path.
INLINE Float4 continuous_box(const Pools* p, const ContinuousPath* g)
{
	Float4 box = world_box(g->from, p->attribute + g->from.attribute, 0.0f);
	Vec path = g->way.path;
	Float4 then = make_float4(box.x + path.x, box.y + path.y, box.z + path.x, box.w + path.y);
	return box_grow(box_union(box, then), g->swing);
}

// Whether a collidable goes far against something kinematic. With many such bodies, the search finds out.
RARE int continuous_far_from_some(const Pools* p, const ContinuousPath* g)
{
	int far = p->step.kinematic > KINEMATIC_FEW;
	for (int k = 0; k < p->step.kinematic && !far; ++k)
	{
		int first = p->continuous_body[p->kinematics->body[k]].first;
		far = first > 0 && continuous_far_from(p, g, p->world_shape[first - 1]) > CONTINUOUS_TRAVEL * g->thickness;
	}
	return far;
}

// The kinds that may be in the way of a collidable, a bit each. Sets the box of its path if there are any. As long as its path stays in the
// box of the step, everything near has a contact. Boxes of two that have none are apart: neither gets past the middle of the other as long
// as each leaves its box by less than its thickness. lists: one kind is enough, and a GPU leaves it to guard to compare paths with kinematic
// bodies: finalize would use registers for that.
INLINE int continuous_seeks(const Pools* p, ContinuousPath* g, int lists)
{
	float far = continuous_far(g->way.path, g->swing);
	if (p->collidable_kind[g->index] & KIND_SENSOR || (!g->pressed && !(far > CONTINUOUS_TRAVEL * g->thickness)))
		return 0;
	int moves = far > CONTINUOUS_CROSS * g->thickness, statics = p->tree[1].leaves > 0;
	int kinematic = !g->pressed && p->step.kinematic > 0;
	if (!(moves | kinematic | statics))
		return 0;
	int body = g->from.body, fixed = p->fixed_contacts[body], meets = moves && p->other_contacts[body] != 0;
	if (lists && meets)
		return 1 << KIND_DYNAMIC;
	g->box = continuous_box(p, g);
	Float4 box = p->box[g->index];
	int inside = box_contains(box, g->box);
	int strays =
	    !inside && (moves || kinematic) && !box_contains(box_grow(box, CONTINUOUS_OUTLIER * g->thickness), g->box);
	moves = moves && (strays || meets);
	kinematic = kinematic && (strays || KINEMATIC_CONTACTS(fixed) != 0);
	if (kinematic && (FETCHES || !lists))
		kinematic = continuous_far_from_some(p, g);
	statics = statics && (STATIC_CONTACTS(fixed) != 0 || !inside);
	return moves << KIND_DYNAMIC | kinematic << KIND_KINEMATIC | statics << KIND_STATIC;
}

// Whether a body on which no forces acted, and that has no contacts, went as its boxes foresaw when the step began: it is inside of them.
INLINE int continuous_foreseen(const Pools* p, int body, float gravity_scale)
{
	return p->step.calm && absolute(gravity_scale) <= 1.0f && p->fixed_contacts[body] == 0 &&
	       p->other_contacts[body] == 0;
}

// Whether a body with one collidable, near which there is nothing but one static collidable, passes that. Most of what rolls or slides ends
// here on a CPU, and takes no search.
RARE int continuous_passes_only(const Pools* p, int body, Vec path, float turn)
{
	int k = p->continuous_body[body].first - 1, c = p->static_contact[body];
	if (k < 0 || p->next_collidable[k] != 0 || c < 0 || c >= p->counters->live)
		return 0;
	// the slot may hold another contact by now; if it is one of this body with something static, it is the only one
	Int2 pair = p->pair[c];
	if (pair.x != k || p->collidable_kind[pair.y] != KIND_STATIC)
		return 0;
	ContinuousPath g = continuous_path(p, k, 0, path, turn);
	g.seeks = continuous_seeks(p, &g, 0);
	if (g.seeks == 0)
		return 1;
	if (g.seeks != 1 << KIND_STATIC || !box_contains(p->box[k], g.box))
		return 0;
	WorldShape other = p->world_shape[pair.y];
	return continuous_passes(p, other, continuous_rest(p, other), g.from, g.way,
	                         continuous_depth(&g, KIND_STATIC).deeper);
}

// Whether nothing can be in the way of a body. Most bodies end here.
INLINE int continuous_clear(const Pools* p, int body, Vec path, float turn)
{
	int fixed = p->fixed_contacts[body];
	if (FETCHES && STATIC_CONTACTS(fixed) == 1)
		return continuous_passes_only(p, body, path, turn);
	int seeks = (FETCHES ? STATIC_CONTACTS(fixed) : fixed) != 0;
	for (int k = p->continuous_body[body].first; k > 0 && !seeks; k = p->next_collidable[k - 1])
	{
		ContinuousPath g = continuous_path(p, k - 1, 0, path, turn);
		seeks = continuous_seeks(p, &g, 1);
	}
	return !seeks;
}

// The share of its path that collidable i moves, with its body's displacement.
INLINE ContinuousStop continuous_collidable(const Pools* p, int i, int pressed, Vec path, float turn)
{
	ContinuousPath g = continuous_path(p, i, pressed, path, turn);
	g.seeks = continuous_seeks(p, &g, 0);
	return continuous_search(p, &g);
}

// The collidable so many behind k in the list of a body. Numbers are 1 + index; 0 is the end.
INLINE int continuous_skip(const Pools* p, int k, int count)
{
	for (; k > 0 && count > 0; --count)
		k = p->next_collidable[k - 1];
	return k;
}

// The share of its path that a body moves, by those of its collidables that belong to this part. Parts side by side test
// theirs in the same iteration, because work-items of a GPU wait for each other.
INLINE ContinuousStop continuous_part(const Pools* p, ContinuousBody continuous_body, int part, Vec path, float turn)
{
	ContinuousStop least = continuous_stop(1.0f, vec(0.0f, 0.0f), 0);
	int pressed = part < 0;
	for (int k = continuous_skip(p, continuous_body.first, part); k > 0;
	     k = continuous_skip(p, k, pressed ? 1 : continuous_body.parts))
	{
		ContinuousStop stop = continuous_collidable(p, k - 1, pressed, path, turn);
		if (stop.share < least.share)
			least = stop;
	}
	return least;
}

// Whether something static may be near the path of a body whose points are no further from its center of mass than reach, m. A GPU looks
// for it in guard.
INLINE int continuous_near_statics(const Pools* p, int body, Vec path, float reach)
{
	const GLOBAL Tree* tree = p->tree + 1;
	if (!FETCHES || tree->leaves == 0)
		return tree->leaves > 0;
	Float4 pose = p->pose[body];
	Float4 box = make_float4(pose.x + minimum(path.x, 0.0f), pose.y + minimum(path.y, 0.0f),
	                         pose.x + maximum(path.x, 0.0f), pose.y + maximum(path.y, 0.0f));
	return tree_hits(p, tree->begin[tree->top], box_grow(box, reach)) != 0;
}

// Whether a body goes far enough to be tested. The bounds in Step rule most bodies out without reading their own rows.
INLINE int continuous_wanted(const Pools* p, int body, Vec path, float turn)
{
	float far = absolute(path.x) + absolute(path.y), swing = absolute(turn);
	if (!(far + swing * p->step.continuous_reach > p->step.continuous_way))
		return 0;
	ContinuousBody continuous_body = p->continuous_body[body];
	far = far + swing * continuous_body.reach;
	if (far > CONTINUOUS_CROSS / CONTINUOUS_TRAVEL * continuous_body.way)
		return 1;
	return far > continuous_body.way &&
	       (p->step.kinematic || continuous_near_statics(p, body, path, continuous_body.reach));
}

// Whether a body that is pressed so deep into something static, m, goes so far that it may get too deep.
INLINE int continuous_presses(const Pools* p, int body, float depth, Vec path, float turn)
{
	return depth + continuous_far(path, absolute(turn) * p->continuous_body[body].reach) > PRESS_MOST;
}

// A GPU combines atomics of neighboring work-items that add 1 each.
INLINE void continuous_enlist(const Pools* p, int body)
{
	int parts = p->continuous_body[body].parts;
	if (parts == 1)
	{
		p->continuous_list[atomic_add_int(&p->counters->continuous_items, 1)] = make_int2(body, 0);
		return;
	}
	int place = atomic_add_int(&p->counters->continuous_items, parts);
	for (int part = 0; part < parts; ++part)
		p->continuous_list[place + part] = make_int2(body, part);
	p->continuous_share[body] = float_bits(1.0f);
	p->continuous_parts[body] = 0;
}

// Whether all parts of a body are done, this one last. Then share is the least of all parts.
INLINE int continuous_all(const Pools* p, ContinuousBody continuous_body, int body, float* share)
{
	if (continuous_body.parts == 1)
		return 1;
	// shares are not negative, so they are ordered like their bits
	if (*share < 1.0f)
		atomic_min_int(&p->continuous_share[body], float_bits(*share));
	if (arrive_int(&p->continuous_parts[body]) + 1 < continuous_body.parts)
		return 0;
	*share = bits_float(read_shared(&p->continuous_share[body]));
	return 1;
}

#endif
