// SPDX-License-Identifier: MIT
// continuous_search.h -- finds the first obstacle on a collidable's path, and the distance that the collidable moves.
#ifndef CONTINUOUS_SEARCH_H
#define CONTINUOUS_SEARCH_H
#include "pools/bays.h"
#include "stages/broad_phase/transform.h"
#include "stages/finalize/continuous_time.h"
#include "stages/rules/apart.h"
#include "stages/tree/tree.h"

// Limits of the depth of a collidable in an obstacle, in m or as fractions of the collidable's thickness.
#define CONTINUOUS_DEPTH   0.25f  // maximum increase of the depth in a step
#define CONTINUOUS_DEEPEST 0.75f  // maximum depth; the middle of the collidable stays outside
#define CONTINUOUS_PRESSED 0.5f   // maximum depth if pressed into something static; also limited to PRESS_MOST
#define CONTINUOUS_SLACK   0.15f  // increase that a dynamic obstacle always allows, so that squeezed bodies slide
#define CONTINUOUS_MOST    0.015f // m: also a limit if the obstacle is not dynamic; if it is lower, piles overlap more

typedef struct // end of a path
{
	float share; // fraction of the path; 1: the whole path
	Vec normal;  // normal of the obstacle, in the world
	int index;   // index of the obstacle
} ContinuousStop;

INLINE ContinuousStop continuous_stop(float share, Vec normal, int index)
{
	ContinuousStop stop;
	stop.share = share;
	stop.normal = normal;
	stop.index = index;
	return stop;
}

// Returns an upper bound of the distance, m, that the points of a shape move. swing: the part due to rotation.
INLINE float continuous_far(Vec path, float swing) { return absolute(path.x) + absolute(path.y) + swing; }

INLINE Advance continuous_went(const Pools* p, int body)
{
	const GLOBAL BodyState* state = p->body + body;
	Advance advance;
	advance.path = vec(state->dx, state->dy);
	advance.turn = state->da;
	return advance;
}

INLINE Sweep continuous_way(const Pools* p, WorldShape s, Advance advance)
{
	const GLOBAL Attribute* attribute = p->attribute + s.attribute;
	return sweep_with(advance, vec(s.center_x, s.center_y), attribute->reach - attribute->radius);
}

#define CONTINUOUS_ROUNDING 1.00001f // factor that enlarges a length by more than its rounding error

// Returns the motion `way`, with the distance of the farthest corner from the center of mass as its reach. The reach of
// sweep_with is a bound that is much larger if a shape is far from its origin: a small spinning body would need more
// than SWEEP_ROUNDS rounds and stay in the air.
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

INLINE Sweep continuous_rest(const Pools* p, WorldShape s)
{
	Advance rests;
	rests.path = vec(0.0f, 0.0f);
	rests.turn = 0.0f;
	s.center_x = s.center_y = 0.0f;
	return continuous_way(p, s, rests);
}

// Returns the vector from the center of mass of the second of two bodies to the point where they met.
INLINE Vec continuous_arm(Sweep way, ContinuousMeeting met)
{
	return vec_sub(met.point, vec_turn(vec_rotation(met.time * way.turn), way.center));
}

// m per step: Returns the speed of the second body at the meeting point, along the normal (away from the first body).
INLINE float continuous_away(Sweep way, ContinuousMeeting met)
{
	return vec_dot(met.normal, vec_add(way.path, vec_spin(way.turn, continuous_arm(way, met))));
}

// Returns whether the second of two bodies moves toward the first one at the point where they met.
INLINE int continuous_yields(Sweep way, ContinuousMeeting met) { return continuous_away(way, met) < 0.0f; }

typedef struct // collidable and its path
{
	int index, pressed;     // `pressed`: 1 if pressed into something static, so that the depth is limited to PRESS_MOST
	int seeks;              // bit k: collidables of kind k may obstruct this one
	float thickness, swing; // m; `swing`: upper bound of the motion of points by the rotation
	WorldShape from;
	Sweep way;
	Float4 box;
	Filter filter;
} ContinuousPath;

// Returns the fraction of its path that a collidable moves if it follows a kinematic collidable after their meeting.
INLINE float continuous_follows(const ContinuousPath* g, WorldShape other, Sweep goes, ContinuousMeeting met)
{
	Vec center = vec_add(vec(g->from.x - other.x, g->from.y - other.y), vec_sub(g->way.center, goes.center));
	Vec arm =
	    vec_add(vec_add(center, vec_scale(met.time, vec_sub(g->way.path, goes.path))), continuous_arm(g->way, met));
	float away = vec_dot(met.normal, vec_add(goes.path, vec_spin(goes.turn, arm)));
	float keeps = within(quotient(away, continuous_away(g->way, met)), 1.0f);
	return met.time + (1.0f - met.time) * maximum(keeps, 0.0f);
}

#define CONTINUOUS_LEAVES (FETCHES ? 1 : 4) // number of leaves read together: their latencies overlap on a GPU

typedef struct // data of a leaf that suffice to exclude most leaves
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

// m: Returns an upper bound of the motion of a collidable's points in the rotating frame of a kinematic body, so that a
// drum does not obstruct a body that turns with it. other: a shape of the kinematic body.
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

// Returns whether a leaf may stop a collidable: it is static, or the two move relative to each other by more than a
// fraction of the collidable's thickness: CONTINUOUS_TRAVEL if the leaf is kinematic, CONTINUOUS_CROSS if it is
// dynamic. Excludes the collidable itself and moving leaves that its filter rejects.
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

// Returns a mask of those leaves of the mask `leaves` that may stop a collidable. Bit 0 is the leaf at place `first`.
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

// Returns the limits of the depth to which a collidable may get into an obstacle. kind: KIND_* of the obstacle.
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

// Returns the end of a collidable's path at obstacle j if it precedes the end `least`, otherwise `least`. Of two ends
// at one fraction, returns that with the lower obstacle index, because the order of leaves depends on the device.
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
	// tests one-way platforms first, because the time of meeting takes longer to compute
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

typedef struct // state of a loop over the leaves that may stop a collidable: first tree 0, then tree 1 (static)
{
	int tree, place; // `place`: first leaf of the current node
	Word64 leaves;   // mask of the remaining leaves of that node
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

INLINE int continuous_seeks_in(const Pools* p, const ContinuousPath* g, int t)
{
	int statics = 1 << KIND_STATIC;
	if (BATCHED(p))
		return t == 0;
	return (g->seeks & (t == 1 ? statics : ~statics)) != 0 && p->tree[t].leaves > 0;
}

// Returns the index of the next collidable, -1 after the last.
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
		int from = bay_of_collidable(p, g->index) * p->step.bays.collidables;
		w->traversal = tree_traverse(p, p->tree + w->tree, g->box, from, from + p->step.bays.collidables, 0x7fffffff);
	}
	int bit = lowest_bit(w->leaves);
	w->leaves &= w->leaves - (Word64)1;
	return p->leaf[w->place + bit];
}

// Returns the end of a path. Each work-item first advances to its next leaf, and then computes a meeting, so that
// neighboring work-items do this long computation at the same time.
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
