// SPDX-License-Identifier: MIT
// continuous.h -- continuous collision: stops a body that the solver would move through something.
//
// A body that moved more than a fraction of its thickness is swept against the collidables along its path, and stops
// slightly inside the surface of the first of them (docs/design/continuous.md). The order of bodies does not matter, because
// this stage reads only data that it does not write. Such bodies are few, and the work per body is long, so finalize
// lists them for a separate kernel: inside finalize, this code raised the number of registers of every work-item of a
// GPU, and 1M bodies in motion took 0.159 ms instead of 0.043 ms on an H200.
//
// This work is based on:
// Erin Catto, Continuous Collision, GDC 2013: static shapes stop moving ones, at a target inside the surface.
#ifndef CONTINUOUS_H
#define CONTINUOUS_H
#include "stages/finalize/continuous_search.h"

// fraction of a collidable's thickness. If the path of a collidable leaves its box of the step by more than this, the
// collidable is also swept against moving collidables with which it has no contact. Other paths need no such sweep: the
// boxes of two collidables without a contact are apart, so neither collidable can pass the middle of the other.
#define CONTINUOUS_OUTLIER 0.5f

// Returns the path of collidable i, which moves with its body. path, turn: displacement and rotation of the body.
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

INLINE Float4 continuous_box(const Pools* p, const ContinuousPath* g)
{
	Float4 box = world_box(g->from, p->attribute + g->from.attribute, 0.0f);
	Vec path = g->way.path;
	Float4 then = make_float4(box.x + path.x, box.y + path.y, box.z + path.x, box.w + path.y);
	return box_grow(box_union(box, then), g->swing);
}

// Returns whether a collidable moves by more than CONTINUOUS_TRAVEL times its thickness relative to some kinematic
// body. With more than KINEMATIC_FEW kinematic bodies, returns 1 without a test.
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

// Returns a mask of the kinds that may obstruct a collidable, one bit per kind. If its path stays in its box of the
// step, these are only kinds with which its body has contacts. If the mask is not 0, also sets g->box. If `lists` is 1,
// the caller uses only whether the mask is 0: then g->box may remain unset, and a GPU, to save registers, leaves the
// test of distances to kinematic bodies to the kernel continuous.
INLINE int continuous_seeks(const Pools* p, ContinuousPath* g, int lists)
{
	float far = continuous_far(g->way.path, g->swing);
	if (p->collidable_kind[g->index] & KIND_SENSOR || (!g->pressed && !(far > CONTINUOUS_TRAVEL * g->thickness)))
		return 0;
	int moves = far > CONTINUOUS_CROSS * g->thickness, statics = tree_statics(p);
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

// Returns whether a body certainly has not left the boxes of its collidables: it has no contacts, so it moved as
// predicted at the start of the step. The caller checks that the user has applied no force.
INLINE int continuous_foreseen(const Pools* p, int body, float gravity_scale)
{
	return bay_calm(p, body) && absolute(gravity_scale) <= 1.0f && p->fixed_contacts[body] == 0 &&
	       p->other_contacts[body] == 0;
}

// Returns 1 if a body has only one collidable and nothing can obstruct it, not even the only static collidable with
// which it has a contact; 0 if that is not certain. On a CPU this ends the test of most rolling bodies.
RARE int continuous_passes_only(const Pools* p, int body, Vec path, float turn)
{
	int k = p->continuous_body[body].first - 1, c = p->static_contact[body];
	if (k < 0 || p->next_collidable[k] != 0 || c < 0 || c >= p->counters->live)
		return 0;
	// the slot may have been reused; any contact of collidable k with something static is the right one
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

// Returns 1 if certainly nothing can obstruct a body, otherwise 0. The result is 1 for most bodies.
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

// Returns the end of the path of collidable i. path, turn: displacement and rotation of its body.
INLINE ContinuousStop continuous_collidable(const Pools* p, int i, int pressed, Vec path, float turn)
{
	ContinuousPath g = continuous_path(p, i, pressed, path, turn);
	g.seeks = continuous_seeks(p, &g, 0);
	return continuous_search(p, &g);
}

// Returns the collidable that is `count` places after collidable k in a body's list. Both are 1 + index; 0 is the end.
INLINE int continuous_skip(const Pools* p, int k, int count)
{
	for (; k > 0 && count > 0; --count)
		k = p->next_collidable[k - 1];
	return k;
}

// Returns the earliest stop among collidables number `part`, part + parts, part + 2 parts and so on of a body; if
// `part` is -1, among all collidables of a pressed body. With this stride all parts need about the same number of
// iterations, so few work-items of a GPU wait for others.
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

// Returns whether something static may be near a body's path. On a GPU, returns only whether the static tree has
// leaves; the path is tested later. reach: as in ContinuousBody.
INLINE int continuous_near_statics(const Pools* p, int body, Vec path, float reach)
{
	const GLOBAL Tree* tree = p->tree + 1;
	if (!FETCHES || tree->leaves == 0)
		return tree_statics(p);
	Float4 pose = p->pose[body];
	Float4 box = make_float4(pose.x + minimum(path.x, 0.0f), pose.y + minimum(path.y, 0.0f),
	                         pose.x + maximum(path.x, 0.0f), pose.y + maximum(path.y, 0.0f));
	return tree_hits(p, tree->begin[tree->top], box_grow(box, reach)) != 0;
}

// Returns whether a body must be tested for obstacles: it moves by more than CONTINUOUS_CROSS times its thickness or,
// if something static is near or the world has kinematic bodies, by more than CONTINUOUS_TRAVEL times its thickness.
// Bounds in Step exclude most bodies before their data are read.
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

// Returns whether a body may get deeper than PRESS_MOST into something static. depth, m: its depth before the step.
INLINE int continuous_presses(const Pools* p, int body, float depth, Vec path, float turn)
{
	return depth + continuous_far(path, absolute(turn) * p->continuous_body[body].reach) > PRESS_MOST;
}

// Lists a body for the kernel continuous, once per part. Bodies with one part have a separate branch, because a GPU
// combines the atomic additions of 1 by neighboring work-items.
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

// Returns whether this part of a body finishes last; if so, *share becomes the smallest *share of all parts.
INLINE int continuous_all(const Pools* p, ContinuousBody continuous_body, int body, float* share)
{
	if (continuous_body.parts == 1)
		return 1;
	// non-negative floats have the same order as their bits
	if (*share < 1.0f)
		atomic_min_int(&p->continuous_share[body], float_bits(*share));
	if (arrive_int(&p->continuous_parts[body]) + 1 < continuous_body.parts)
		return 0;
	*share = bits_float(read_shared(&p->continuous_share[body]));
	return 1;
}

#endif
