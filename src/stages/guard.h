// SPDX-License-Identifier: MIT
// guard.h -- a body that the solver would move through something stops inside its surface.
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
#ifndef GUARD_H
#define GUARD_H
#include "stages/apart.h"
#include "stages/guard_time.h"
#include "stages/transform.h"
#include "stages/tree.h"

// of the thickness: how much deeper a body may be at the end of the step than before; and how deep in all, so that its
// middle stays outside
#define GUARD_DEPTH   0.25f
#define GUARD_DEEPEST 0.75f
// share of the thickness: how deep a body that is pressed into something static may be, if that is less than PRESS_MOST
#define GUARD_PRESSED 0.5f
// share of the thickness: a path that leaves the box of the step by more is swept against what moves and has no contact
#define GUARD_STRAY 0.5f
// of the thickness: how much deeper in something dynamic always, so that what is squeezed in between slides on
#define GUARD_SLACK 0.15f
// m: how much deeper in something static at most; less holds more bodies of a pile, which then overlap more
#define GUARD_MOST 0.015f

typedef struct // where a path ends
{
	float share; // of the path, 1 is all
	Vec normal;  // of what ends it, in the world
	int index;   // of that collidable
} GuardStop;

INLINE GuardStop guard_stop(float share, Vec normal, int index)
{
	GuardStop stop;
	stop.share = share;
	stop.normal = normal;
	stop.index = index;
	return stop;
}

// The distance that points of something may go, of which swing is by its turn, m.
INLINE float guard_far(Vec path, float swing) { return absolute(path.x) + absolute(path.y) + swing; }

// How the body of a dynamic collidable went in the step.
INLINE Advance guard_went(const Pools* p, int body)
{
	const GLOBAL BodyState* state = p->body + body;
	Advance advance;
	advance.path = vec(state->dx, state->dy);
	advance.turn = state->da;
	return advance;
}

// The way of a collidable, with its body's displacement.
INLINE Sweep guard_way(const Pools* p, WorldShape s, Advance advance)
{
	const GLOBAL Attribute* attribute = p->attribute + s.attribute;
	return sweep_with(advance, vec(s.center_x, s.center_y), attribute->reach - attribute->radius);
}

// factor of a length: more than rounding may shorten it
#define GUARD_ROUNDING 1.00001f

// The same with the reach of its corners. The bound that sweep_with has is many times as much where a shape lies far from its origin:
// what is small and spins would take more rounds than there are, and stay in the air.
INLINE Sweep guard_near(const Pools* p, WorldShape s, Sweep way)
{
	const GLOBAL Attribute* attribute = p->attribute + s.attribute;
	float square = 0.0f;
	for (int k = 0; k < attribute->count; ++k)
	{
		Vec arm = vec_sub(vec_turn(vec(s.c, s.s), shape_corner(attribute, k)), way.center);
		square = maximum(square, vec_dot(arm, arm));
	}
	way.reach = minimum(way.reach, GUARD_ROUNDING * square_root(square));
	return way;
}

// The way of something that does not move.
INLINE Sweep guard_rest(const Pools* p, WorldShape s)
{
	Advance rests;
	rests.path = vec(0.0f, 0.0f);
	rests.turn = 0.0f;
	s.center_x = s.center_y = 0.0f;
	return guard_way(p, s, rests);
}

// From the center of the body of the second of two that met to where they did.
INLINE Vec guard_arm(Sweep way, GuardMeeting met)
{
	return vec_sub(met.point, vec_turn(vec_rotation(met.time * way.turn), way.center));
}

// How far the second of two goes away from the first one there in a step, m.
INLINE float guard_away(Sweep way, GuardMeeting met)
{
	return vec_dot(met.normal, vec_add(way.path, vec_spin(way.turn, guard_arm(way, met))));
}

// Whether the second of two that met goes towards the first one there.
INLINE int guard_yields(Sweep way, GuardMeeting met) { return guard_away(way, met) < 0.0f; }

typedef struct // a collidable on its path
{
	int index, pressed;     // pressed: into something static, so that it may get no deeper than PRESS_MOST
	int seeks;              // bit k: what has the kind k may be in its way
	float thickness, swing; // m
	WorldShape from;
	Sweep way;
	Float4 box;
	Filter filter;
} GuardPath;

// The share of its path after which a collidable keeps up with something kinematic that it met.
INLINE float guard_follows(const GuardPath* g, WorldShape other, Sweep goes, GuardMeeting met)
{
	Vec center = vec_add(vec(g->from.x - other.x, g->from.y - other.y), vec_sub(g->way.center, goes.center));
	Vec arm = vec_add(vec_add(center, vec_scale(met.time, vec_sub(g->way.path, goes.path))), guard_arm(g->way, met));
	float away = vec_dot(met.normal, vec_add(goes.path, vec_spin(goes.turn, arm)));
	float keeps = within(away / guard_away(g->way, met), 1.0f);
	return met.time + (1.0f - met.time) * maximum(keeps, 0.0f);
}

// Whether j may stop a collidable: it is static, or the two go so far against each other that one may get past the middle of the other.
INLINE int guard_meets(const Pools* p, const GuardPath* g, int j)
{
	// all that most leaves need is read at once: a GPU waits for it once
	int kind = p->collidable_kind[j], body = p->collidable_body[j];
	Filter filter = p->filter[j];
	if (!(g->seeks >> kind & 1))
		return 0;
	if (kind == KIND_STATIC)
		return 1;
	// soon ruled out: itself, and what its filter leaves alone
	if (j == g->index || !filter_accepts(g->filter, filter))
		return 0;
	Advance went = guard_went(p, body);
	float swing = g->swing + absolute(went.turn) * p->guarded[body].reach;
	float least = kind == KIND_DYNAMIC ? GUARD_CROSS : GUARD_TRAVEL;
	return guard_far(vec_sub(g->way.path, went.path), swing) > least * g->thickness;
}

// The end of the path of a collidable by j, which may stop it, if that comes before least. Leaves are not in the same order everywhere:
// of equal shares, the lower index counts.
RARE GuardStop guard_leaf(const Pools* p, const GuardPath* g, int j, GuardStop least)
{
	int i = g->index, kind = p->collidable_kind[j], moves = kind != KIND_STATIC;
	Advance went;
	Vec apart = g->way.path;
	if (moves)
	{
		went = guard_went(p, p->collidable_body[j]);
		apart = vec_sub(apart, went.path);
	}
	if (apart_by(p, i, j, APART_ALL))
		return least;
	// takes less time than to find when they meet
	if (p->step.rules && (apart_lets(p, j, i, apart, g->swing) || apart_lets(p, i, j, vec_neg(apart), g->swing)))
		return least;
	WorldShape other = p->world_shape[j];
	Sweep goes = moves ? guard_near(p, other, guard_way(p, other, went)) : guard_rest(p, other);
	GuardDepth deep;
	deep.deeper = kind == KIND_DYNAMIC ? GUARD_DEPTH * g->thickness : minimum(GUARD_DEPTH * g->thickness, GUARD_MOST);
	deep.deepest = GUARD_DEEPEST * g->thickness;
	deep.slack = kind == KIND_DYNAMIC ? maximum(GUARD_SLACK * g->thickness, GUARD_TOLERANCE) : GUARD_TOLERANCE;
	deep.pressed = g->pressed && !moves ? minimum(GUARD_PRESSED * g->thickness, PRESS_MOST) : 0.0f;
	GuardMeeting met = guard_time(p, other, goes, g->from, guard_near(p, g->from, g->way), deep);
	if (!(met.time < 1.0f) || (moves && !guard_yields(g->way, met)))
		return least;
	float share = kind == KIND_KINEMATIC ? guard_follows(g, other, goes, met) : met.time;
	if (!(share < 1.0f) || share > least.share || (share == least.share && j > least.index))
		return least;
	return guard_stop(share, met.normal, j);
}

// The end of a path by the leaves of a tree, if that comes before least.
RARE GuardStop guard_search(const Pools* p, const GLOBAL Tree* tree, const GuardPath* g, GuardStop least)
{
	if (tree->leaves == 0)
		return least;
	Float4 box = g->box;
	TreeWalk walk = tree_walk(p, tree, box, 0, 0, 0x7fffffff);
	for (int first = tree_next(p, tree, box, &walk); first >= 0; first = tree_next(p, tree, box, &walk))
		for (Word64 leaves = walk.leaves; leaves != 0; leaves &= leaves - (Word64)1)
		{
			int j = p->leaf[tree->leaf_begin + first + lowest_bit(leaves)];
			if (guard_meets(p, g, j))
				least = guard_leaf(p, g, j, least);
		}
	return least;
}

// The way of collidable i with its body's displacement.
INLINE GuardPath guard_path(const Pools* p, int i, int pressed, Vec path, float turn)
{
	GuardPath g;
	Advance advance;
	advance.path = path;
	advance.turn = turn;
	g.index = i;
	g.pressed = pressed;
	g.from = p->world_shape[i];
	g.filter = p->filter[i];
	g.thickness = p->thickness[g.from.attribute];
	g.way = guard_way(p, g.from, advance);
	g.swing = absolute(turn) * g.way.reach;
	Float4 box = world_box(g.from, p->attribute + g.from.attribute, 0.0f);
	Float4 then = make_float4(box.x + path.x, box.y + path.y, box.z + path.x, box.w + path.y);
	g.box = box_grow(box_union(box, then), g.swing);
	return g;
}

// The kinds that may be in the way of a collidable, a bit each. As long as its path stays in the box of the step, everything near has a
// contact. Boxes of two that have none are apart: neither gets past the middle of the other as long as each leaves its box by less than
// its thickness.
INLINE int guard_seeks(const Pools* p, const GuardPath* g)
{
	float far = guard_far(g->way.path, g->swing);
	if (p->collidable_kind[g->index] & KIND_SENSOR || (!g->pressed && !(far > GUARD_TRAVEL * g->thickness)))
		return 0;
	int body = g->from.body, fixed = p->fixed_contacts[body];
	Float4 box = p->box[g->index];
	int moves = far > GUARD_CROSS * g->thickness, kinematic = p->step.kinematic && !g->pressed;
	int inside = box_contains(box, g->box);
	int strays = !inside && (moves || kinematic) && !box_contains(box_grow(box, GUARD_STRAY * g->thickness), g->box);
	moves = moves && (strays || p->other_contacts[body] != 0);
	kinematic = kinematic && (strays || fixed >= KINEMATIC_CONTACT);
	int statics = p->tree[1].leaves > 0 && (fixed != 0 || !inside);
	return moves << KIND_DYNAMIC | kinematic << KIND_KINEMATIC | statics << KIND_STATIC;
}

// Whether a body on which no forces acted, and that has no contacts, went as its boxes foresaw when the step began: it is inside of them.
INLINE int guard_foreseen(const Pools* p, int body, float gravity_scale)
{
	return p->step.calm && absolute(gravity_scale) <= 1.0f && p->fixed_contacts[body] == 0 &&
	       p->other_contacts[body] == 0;
}

// Whether nothing can be in the way of a body. Most bodies end here.
INLINE int guard_clear(const Pools* p, int body, Vec path, float turn)
{
	int seeks = p->fixed_contacts[body] != 0;
	for (int k = p->guarded[body].first; k > 0 && !seeks; k = p->next_collidable[k - 1])
	{
		GuardPath g = guard_path(p, k - 1, 0, path, turn);
		seeks = guard_seeks(p, &g);
	}
	return !seeks;
}

// The share of its path that collidable i moves, with its body's displacement.
INLINE GuardStop guard_collidable(const Pools* p, int i, int pressed, Vec path, float turn)
{
	GuardStop least = guard_stop(1.0f, vec(0.0f, 0.0f), 0);
	GuardPath g = guard_path(p, i, pressed, path, turn);
	int statics = 1 << KIND_STATIC;
	g.seeks = guard_seeks(p, &g);
	// one call for both trees, as in guard
	for (int t = 0; t < 2; ++t)
		if (g.seeks & (t == 1 ? statics : ~statics))
			least = guard_search(p, p->tree + t, &g, least);
	return least;
}

// The collidable so many behind k in the list of a body. Numbers are 1 + index; 0 is the end.
INLINE int guard_skip(const Pools* p, int k, int count)
{
	for (; k > 0 && count > 0; --count)
		k = p->next_collidable[k - 1];
	return k;
}

// The share of its path that a body moves, by those of its collidables that belong to this part. Parts side by side test
// theirs in the same iteration, because work-items of a GPU wait for each other.
INLINE GuardStop guard_part(const Pools* p, Guarded guarded, int part, Vec path, float turn)
{
	GuardStop least = guard_stop(1.0f, vec(0.0f, 0.0f), 0);
	int pressed = part < 0;
	for (int k = guard_skip(p, guarded.first, part); k > 0; k = guard_skip(p, k, pressed ? 1 : guarded.parts))
	{
		GuardStop stop = guard_collidable(p, k - 1, pressed, path, turn);
		if (stop.share < least.share)
			least = stop;
	}
	return least;
}

// Whether a body goes far enough to be tested. The bounds in Step rule most bodies out without reading their own rows.
INLINE int guard_wanted(const Pools* p, int body, Vec path, float turn)
{
	float far = absolute(path.x) + absolute(path.y), swing = absolute(turn);
	if (!(far + swing * p->step.guard_reach > p->step.guard_way))
		return 0;
	Guarded guarded = p->guarded[body];
	float way = p->tree[1].leaves > 0 || p->step.kinematic ? guarded.way : GUARD_CROSS / GUARD_TRAVEL * guarded.way;
	return far + swing * guarded.reach > way;
}

// Whether a body that is pressed so deep into something static, m, goes so far that it may get too deep.
INLINE int guard_presses(const Pools* p, int body, float depth, Vec path, float turn)
{
	return depth + guard_far(path, absolute(turn) * p->guarded[body].reach) > PRESS_MOST;
}

// A GPU combines atomics of neighboring work-items that add 1 each.
INLINE void guard_enlist(const Pools* p, int body)
{
	int parts = p->guarded[body].parts;
	if (parts == 1)
	{
		p->guard_list[atomic_add_int(&p->counters->guarded, 1)] = make_int2(body, 0);
		return;
	}
	int place = atomic_add_int(&p->counters->guarded, parts);
	for (int part = 0; part < parts; ++part)
		p->guard_list[place + part] = make_int2(body, part);
	p->guard_share[body] = float_bits(1.0f);
	p->guard_parts[body] = 0;
}

// Whether all parts of a body are done, this one last. Then share is the least of all parts.
INLINE int guard_all(const Pools* p, Guarded guarded, int body, float* share)
{
	if (guarded.parts == 1)
		return 1;
	// shares are not negative, so they are ordered like their bits
	if (*share < 1.0f)
		atomic_min_int(&p->guard_share[body], float_bits(*share));
	if (arrive_int(&p->guard_parts[body]) + 1 < guarded.parts)
		return 0;
	*share = bits_float(read_shared(&p->guard_share[body]));
	return 1;
}

#endif
