// SPDX-License-Identifier: MIT
// continuous_search.h -- the end of a collidable's path: what it meets first of what is in its way, and how far it goes.
#ifndef CONTINUOUS_SEARCH_H
#define CONTINUOUS_SEARCH_H
#include "stages/broad_phase/transform.h"
#include "stages/finalize/continuous_time.h"
#include "stages/rules/apart.h"
#include "stages/tree/tree.h"

// share of the thickness: how much deeper a body may be at the end of the step than before; and how deep in all, so that its
// middle stays outside
#define CONTINUOUS_DEPTH   0.25f
#define CONTINUOUS_DEEPEST 0.75f
// share of the thickness: how deep a body that is pressed into something static may be, if that is less than PRESS_MOST
#define CONTINUOUS_PRESSED 0.5f
// share of the thickness: how much deeper in something dynamic always, so that what is squeezed in between slides on
#define CONTINUOUS_SLACK 0.15f
// m: how much deeper in something static at most; less holds more bodies of a pile, which then overlap more
#define CONTINUOUS_MOST 0.015f

typedef struct // the end of a path
{
	float share; // part of the path, 1 is all
	Vec normal;  // of what ends it, in the world
	int index;   // of that collidable
} ContinuousStop;

INLINE ContinuousStop continuous_stop(float share, Vec normal, int index)
{
	ContinuousStop stop;
	stop.share = share;
	stop.normal = normal;
	stop.index = index;
	return stop;
}

// The distance that points of something may go, of which swing is by its turn, m.
INLINE float continuous_far(Vec path, float swing) { return absolute(path.x) + absolute(path.y) + swing; }

// How the body of a dynamic collidable went in the step.
INLINE Advance continuous_went(const Pools* p, int body)
{
	const GLOBAL BodyState* state = p->body + body;
	Advance advance;
	advance.path = vec(state->dx, state->dy);
	advance.turn = state->da;
	return advance;
}

// The way of a collidable, with its body's displacement.
INLINE Sweep continuous_way(const Pools* p, WorldShape s, Advance advance)
{
	const GLOBAL Attribute* attribute = p->attribute + s.attribute;
	return sweep_with(advance, vec(s.center_x, s.center_y), attribute->reach - attribute->radius);
}

// factor of a length: more than rounding may shorten it
#define CONTINUOUS_ROUNDING 1.00001f

// The same with the reach of its corners. The bound that sweep_with has is many times as much where a shape lies far from its origin:
// what is small and spins would take more rounds than there are, and stay in the air.
INLINE Sweep continuous_near(const Pools* p, WorldShape s, Sweep way)
{
	const GLOBAL Attribute* attribute = p->attribute + s.attribute;
	float square = 0.0f;
	for (int k = 0; k < attribute->count; ++k)
	{
		Vec arm = vec_sub(vec_turn(vec(s.c, s.s), shape_corner(attribute, k)), way.center);
		square = maximum(square, vec_dot(arm, arm));
	}
	way.reach = minimum(way.reach, CONTINUOUS_ROUNDING * square_root(square));
	return way;
}

// The way of something that does not move.
INLINE Sweep continuous_rest(const Pools* p, WorldShape s)
{
	Advance rests;
	rests.path = vec(0.0f, 0.0f);
	rests.turn = 0.0f;
	s.center_x = s.center_y = 0.0f;
	return continuous_way(p, s, rests);
}

// From the center of the body of the second of two that met to where they did.
INLINE Vec continuous_arm(Sweep way, ContinuousMeeting met)
{
	return vec_sub(met.point, vec_turn(vec_rotation(met.time * way.turn), way.center));
}

// How far the second of two goes away from the first one there in a step, m.
INLINE float continuous_away(Sweep way, ContinuousMeeting met)
{
	return vec_dot(met.normal, vec_add(way.path, vec_spin(way.turn, continuous_arm(way, met))));
}

// Whether the second of two that met goes towards the first one there.
INLINE int continuous_yields(Sweep way, ContinuousMeeting met) { return continuous_away(way, met) < 0.0f; }

typedef struct // a collidable on its path
{
	int index, pressed;     // pressed: into something static, so that it may get no deeper than PRESS_MOST
	int seeks;              // bit k: what has the kind k may be in its way
	float thickness, swing; // m
	WorldShape from;
	Sweep way;
	Float4 box;
	Filter filter;
} ContinuousPath;

// The share of its path after which a collidable keeps up with something kinematic that it met.
INLINE float continuous_follows(const ContinuousPath* g, WorldShape other, Sweep goes, ContinuousMeeting met)
{
	Vec center = vec_add(vec(g->from.x - other.x, g->from.y - other.y), vec_sub(g->way.center, goes.center));
	Vec arm =
	    vec_add(vec_add(center, vec_scale(met.time, vec_sub(g->way.path, goes.path))), continuous_arm(g->way, met));
	float away = vec_dot(met.normal, vec_add(goes.path, vec_spin(goes.turn, arm)));
	float keeps = within(away / continuous_away(g->way, met), 1.0f);
	return met.time + (1.0f - met.time) * maximum(keeps, 0.0f);
}

// Leaves of which what rules most of them out is read at once: a GPU waits for it once, a CPU gains nothing.
#define CONTINUOUS_LEAVES (FETCHES ? 1 : 4)

typedef struct // facts that rule out a leaf
{
	int index, kind, body;
	Filter filter;
} ContinuousLeaf;

INLINE ContinuousLeaf continuous_leaf_at(const Pools* p, int place)
{
	ContinuousLeaf leaf;
	leaf.index = p->leaf[place];
	leaf.kind = p->collidable_kind[leaf.index];
	leaf.body = p->collidable_body[leaf.index];
	leaf.filter = p->filter[leaf.index];
	return leaf;
}

// How far points of a collidable may go against a kinematic body, as one sees it who turns with the body, m. other is a shape of that body.
// A body that goes round with a drum does not go far, and has nothing in its way.
INLINE float continuous_far_from(const Pools* p, const ContinuousPath* g, WorldShape other)
{
	Advance went = continuous_went(p, other.body);
	Vec apart = vec_sub(g->way.path, went.path);
	Vec arm = vec(g->from.x - other.x + (g->from.center_x - other.center_x),
	              g->from.y - other.y + (g->from.center_y - other.center_y));
	Vec middle = vec_add(arm, vec_scale(0.5f, apart));
	float swing = absolute(g->way.turn - went.turn) * g->way.reach;
	return continuous_far(vec_sub(apart, vec_spin(went.turn, middle)), swing);
}

// Whether a leaf may stop a collidable: it is static, or the two go so far against each other that one may get past the middle of the
// other. Soon ruled out are the collidable itself, and what its filter leaves alone.
INLINE int continuous_meets(const Pools* p, const ContinuousPath* g, const ContinuousLeaf* leaf)
{
	if (!(g->seeks >> leaf->kind & 1))
		return 0;
	if (leaf->kind == KIND_STATIC)
		return 1;
	if (leaf->index == g->index || !filter_accepts(g->filter, leaf->filter))
		return 0;
	if (leaf->kind == KIND_KINEMATIC)
		return continuous_far_from(p, g, p->world_shape[leaf->index]) > CONTINUOUS_TRAVEL * g->thickness;
	Advance went = continuous_went(p, leaf->body);
	float swing = g->swing + absolute(went.turn) * p->continuous_body[leaf->body].reach;
	return continuous_far(vec_sub(g->way.path, went.path), swing) > CONTINUOUS_CROSS * g->thickness;
}

// The leaves from first on that may stop a collidable, a bit each, as in leaves.
INLINE Word64 continuous_meeting(const Pools* p, const ContinuousPath* g, int first, Word64 leaves)
{
	Word64 meeting = 0;
	while (leaves != 0)
	{
		ContinuousLeaf leaf[CONTINUOUS_LEAVES];
		int bit[CONTINUOUS_LEAVES];
		UNROLL
		for (int k = 0; k < CONTINUOUS_LEAVES; ++k)
		{
			bit[k] = leaves != 0 ? lowest_bit(leaves) : bit[0];
			leaves &= leaves - (Word64)1;
		}
		UNROLL
		for (int k = 0; k < CONTINUOUS_LEAVES; ++k)
			leaf[k] = continuous_leaf_at(p, first + bit[k]);
		UNROLL
		for (int k = 0; k < CONTINUOUS_LEAVES; ++k)
			if (continuous_meets(p, g, leaf + k))
				meeting |= (Word64)1 << bit[k];
	}
	return meeting;
}

// How deep a collidable may get in something of a kind.
INLINE ContinuousDepth continuous_depth(const ContinuousPath* g, int kind)
{
	ContinuousDepth deep;
	deep.deeper = kind == KIND_DYNAMIC ? CONTINUOUS_DEPTH * g->thickness
	                                   : minimum(CONTINUOUS_DEPTH * g->thickness, CONTINUOUS_MOST);
	deep.deepest = CONTINUOUS_DEEPEST * g->thickness;
	deep.slack =
	    kind == KIND_DYNAMIC ? maximum(CONTINUOUS_SLACK * g->thickness, CONTINUOUS_TOLERANCE) : CONTINUOUS_TOLERANCE;
	deep.pressed = g->pressed && kind == KIND_STATIC ? minimum(CONTINUOUS_PRESSED * g->thickness, PRESS_MOST) : 0.0f;
	return deep;
}

// The end of the path of a collidable by j, which may stop it, if that comes before least. Leaves are not in the same order everywhere:
// of equal shares, the lower index counts.
RARE ContinuousStop continuous_leaf(const Pools* p, const ContinuousPath* g, int j, ContinuousStop least)
{
	int i = g->index, kind = p->collidable_kind[j], moves = kind != KIND_STATIC;
	Advance went;
	Vec apart = g->way.path;
	if (moves)
	{
		went = continuous_went(p, p->collidable_body[j]);
		apart = vec_sub(apart, went.path);
	}
	WorldShape other = p->world_shape[j];
	Sweep goes = moves ? continuous_way(p, other, went) : continuous_rest(p, other);
	ContinuousDepth deep = continuous_depth(g, kind);
	if (continuous_passes(p, other, goes, g->from, g->way,
	                      deep.pressed > 0.0f ? minimum(deep.deeper, deep.pressed) : deep.deeper))
		return least;
	if (apart_by(p, i, j, APART_ALL))
		return least;
	// takes less time than to find when they meet
	if (p->step.rules && (apart_lets(p, j, i, apart, g->swing) || apart_lets(p, i, j, vec_neg(apart), g->swing)))
		return least;
	if (moves)
		goes = continuous_near(p, other, goes);
	ContinuousMeeting met = continuous_time(p, other, goes, g->from, continuous_near(p, g->from, g->way), deep);
	if (!(met.time < 1.0f) || (moves && !continuous_yields(g->way, met)))
		return least;
	float share = kind == KIND_KINEMATIC ? continuous_follows(g, other, goes, met) : met.time;
	if (!(share < 1.0f) || share > least.share || (share == least.share && j > least.index))
		return least;
	return continuous_stop(share, met.normal, j);
}

typedef struct // through the leaves that may stop a collidable, of the tree of what moves, then of what is static
{
	int tree, place; // place: of the first leaf of the node where it is
	Word64 leaves;   // of that node, a bit for each that is left
	TreeTraversal traversal;
} ContinuousTraversal;

INLINE ContinuousTraversal continuous_traverse(void)
{
	ContinuousTraversal w;
	w.tree = -1;
	w.place = 0;
	w.leaves = 0;
	w.traversal.level = w.traversal.first = w.traversal.from = w.traversal.end = w.traversal.nodes =
	    w.traversal.movers = 0;
	w.traversal.masks = w.traversal.leaves = 0;
	return w;
}

// Whether something in a tree may stop a collidable.
INLINE int continuous_seeks_in(const Pools* p, const ContinuousPath* g, int t)
{
	int statics = 1 << KIND_STATIC;
	return (g->seeks & (t == 1 ? statics : ~statics)) != 0 && p->tree[t].leaves > 0;
}

// The next leaf, -1 behind the last.
INLINE int continuous_next(const Pools* p, const ContinuousPath* g, ContinuousTraversal* w)
{
	while (w->leaves == 0)
	{
		int first = w->tree < 0 ? TREE_DONE : tree_next(p, p->tree + w->tree, g->box, &w->traversal);
		if (first >= 0)
		{
			w->place = p->tree[w->tree].leaf_begin + first;
			w->leaves = continuous_meeting(p, g, w->place, w->traversal.leaves);
			continue;
		}
		do
			++w->tree;
		while (w->tree < 2 && !continuous_seeks_in(p, g, w->tree));
		if (w->tree == 2)
			return -1;
		w->traversal = tree_traverse(p, p->tree + w->tree, g->box, 0, 0, 0x7fffffff);
	}
	int bit = lowest_bit(w->leaves);
	w->leaves &= w->leaves - (Word64)1;
	return p->leaf[w->place + bit];
}

// The end of a path. Each work-item goes on to its next leaf before any looks when it meets one, so that work-items side by side do
// that, which takes long, at the same time.
RARE ContinuousStop continuous_search(const Pools* p, const ContinuousPath* g)
{
	ContinuousStop least = continuous_stop(1.0f, vec(0.0f, 0.0f), 0);
	ContinuousTraversal traversal = continuous_traverse();
	for (;;)
	{
		int j = continuous_next(p, g, &traversal);
		if (j < 0)
			return least;
		least = continuous_leaf(p, g, j, least);
	}
}

#endif
