// SPDX-License-Identifier: MIT
// query.h -- executes the user's queries, one per item: rays, moving or resting shapes, and the nearest collidable.
//
// docs/manual/queries.md defines the results. Of two equally near collidables, the one with the lower index is returned.
#ifndef QUERY_H
#define QUERY_H
#include "stages/geometry/convex_sum.h"
#include "stages/read/query_tree.h"
#include "stages/rules/one_way.h"

typedef struct // query in world coordinates
{
	Vec start, turn, path; // position of the shape's origin, m; rotation (cos, sin); path of the origin, m
	float radius;          // m: radius of a ray
	int ignored;           // body that the query ignores, 0 for no body
	Float4 box;            // box of the shape at the start
	Float4 sides;          // x and y of the leading sides of the box (in the direction of the path), then of the others
	Float2 inverse;        // 1/m: inverse of each component of the path
} WorldQuery;

// m: a component of a path with a magnitude below QUERY_STILL counts as 0; its inverse is QUERY_INVERSE, 1/m
#define QUERY_STILL   1.0e-30f
#define QUERY_INVERSE 1.0e30f

INLINE float query_inverse(float path) { return absolute(path) < QUERY_STILL ? QUERY_INVERSE : quotient(1.0f, path); }

// Returns the body that a query ignores; 0 if there is none, or if it was destroyed, as another body may have its slot.
INLINE int query_ignored(const Pools* p, const Query* query)
{
	int body = query->ignored, there = body > 0 && body < p->query_plan->bodies;
	return there && p->body_generation[body] == query->ignored_generation ? body : 0;
}

INLINE WorldQuery query_in_world(const Pools* p, int i, int form)
{
	Query query = p->query[i];
	query.a = make_float4(flush_tiny(query.a.x), flush_tiny(query.a.y), flush_tiny(query.a.z), flush_tiny(query.a.w));
	query.b = make_float2(flush_tiny(query.b.x), flush_tiny(query.b.y));
	WorldQuery q;
	q.start = vec(query.a.x, query.a.y);
	q.turn = vec(1.0f, 0.0f);
	q.radius = 0.0f;
	q.ignored = query_ignored(p, &query);
	if (form == QUERY_RAYS)
	{
		q.path = vec(query.a.z, query.a.w);
		q.radius = query.b.x;
		q.box = box_grow(make_float4(q.start.x, q.start.y, q.start.x, q.start.y), q.radius);
	}
	else
	{
		q.path = vec(query.b.x, query.b.y);
		q.turn = vec(query.a.z, query.a.w);
		WorldShape at;
		at.x = q.start.x;
		at.y = q.start.y;
		at.c = q.turn.x;
		at.s = q.turn.y;
		q.box = world_box(at, &p->query_plan->shape, 0.0f);
	}
	q.inverse = make_float2(query_inverse(q.path.x), query_inverse(q.path.y));
	int right = q.inverse.x > 0.0f, up = q.inverse.y > 0.0f;
	q.sides = make_float4(right ? q.box.z : q.box.x, up ? q.box.w : q.box.y, right ? q.box.x : q.box.z,
	                      up ? q.box.y : q.box.w);
	return q;
}

INLINE QueryResult query_nothing(void)
{
	QueryResult found;
	found.collidable = 0;
	found.generation = 0;
	found.x = found.y = found.normal_x = found.normal_y = 0.0f;
	found.fraction = 0.0f;
	found.marks = 0;
	return found;
}

// Writes the point and the normal of a result in the world. point, normal: in the frame of the leaf.
INLINE void query_place(QueryResult* found, QueryLeaf seen, Vec point, Vec normal)
{
	Vec turn = vec(seen.c, seen.s);
	point = vec_turn(turn, point);
	normal = vec_turn(turn, normal);
	found->x = flush_tiny(seen.x + point.x);
	found->y = flush_tiny(seen.y + point.y);
	found->normal_x = flush_tiny(normal.x);
	found->normal_y = flush_tiny(normal.y);
}

// Tests point q, which moves by a path, against c: the shape of a leaf, or the sum of both shapes, in the frame of the
// leaf. Finds the first contact or, with QUERY_NEAREST, the nearest point. Returns whether there is one.
INLINE int query_solve(Convex c, int form, Vec q, Vec path, ConvexHit* hit)
{
	if (form != QUERY_NEAREST)
	{
		*hit = convex_hit(&c, q, path);
		return hit->hit;
	}
	ConvexNearest n = convex_nearest(&c, q);
	*hit = convex_miss();
	hit->edge = n.edge;
	hit->corner = n.corner;
	hit->normal = n.normal;
	hit->fraction = n.separation;
	hit->inside = n.separation <= 0.0f;
	return 1;
}

// Returns whether a leaf is a one-way platform that lets a query through. f, path: pose and motion of the query in the
// frame of the leaf.
INLINE int query_passes(const Pools* p, QueryLeaf seen, Frame f, float radius, Vec path, const ConvexHit* hit, int form)
{
	Rule rule = p->rule[seen.attribute];
	const GLOBAL Attribute *platform = p->attribute + seen.attribute, *visitor = &p->query_plan->shape;
	if (!rule.one_way)
		return 0;
	if (form == QUERY_NEAREST ? hit->fraction < -ONE_WAY_SLOP : hit->inside)
		return 1;
	Vec up = vec(rule.up_x, rule.up_y);
	OneWayDepth depth = {ONE_WAY_SLOP, 0.0f};
	OneWayWhole whole = one_way_whole(platform, up, visitor, f);
	return one_way_height(platform, up, visitor, f, whole, radius, path, depth) != ONE_WAY_ABOVE;
}

INLINE int query_meets(const Pools* p, QueryLeaf seen, const WorldQuery* asked, int form, QueryResult* found)
{
	const GLOBAL Attribute *a = p->attribute + seen.attribute, *b = &p->query_plan->shape;
	Vec axes = vec(seen.c, seen.s);
	Vec q = vec_flush_tiny(vec_turn_back(axes, vec(asked->start.x - seen.x, asked->start.y - seen.y)));
	Vec path = vec_flush_tiny(vec_turn_back(axes, asked->path)), turn = vec_turn_back(axes, asked->turn), point;
	Frame f = frame_at(q, turn);
	ConvexHit hit;
	if (form == QUERY_RAYS || b->count == 1)
	{
		float radius = form == QUERY_RAYS ? asked->radius : b->radius;
		if (form != QUERY_RAYS)
			q = vec_add(q, vec_turn(turn, shape_corner(b, 0)));
		if (!query_solve(convex_of(a, radius), form, q, path, &hit))
			return 0;
		if (form == QUERY_NEAREST)
			radius += hit.fraction;
		else
			q = vec_add(q, vec_scale(hit.fraction, path));
		point = vec_sub(q, vec_scale(radius, hit.normal));
	}
	else
	{
		Sum sum;
		sum_make(a, b, turn, &sum);
		if (!query_solve(sum_convex(&sum, a->radius + b->radius), form, q, path, &hit))
			return 0;
		if (form != QUERY_NEAREST)
			q = vec_add(q, vec_scale(hit.fraction, path));
		point = sum_point(&sum, a, b, turn, q, hit.edge, hit.corner, hit.normal);
	}
	if (p->query_plan->rules && query_passes(p, seen, f, asked->radius, path, &hit, form))
		return 0;
	if (hit.inside && form != QUERY_NEAREST)
	{
		if (p->query_plan->skips)
			return 0;
		point = q;
	}
	query_place(found, seen, point, hit.normal);
	found->fraction = flush_tiny(hit.fraction);
	found->marks = FOUND_HIT | (hit.inside ? FOUND_INSIDE : 0u);
	found->collidable = seen.collidable + 1; // + 1: handles count from 1
	found->generation = p->generation[seen.collidable];
	return 1;
}

// Returns the fraction of a result or, with QUERY_NEAREST, its squared distance; at least `apart`, which is the same
// value for the leaf's box, because no result is nearer than its box. Except with QUERY_NEAREST, also raises
// found->fraction to `apart`. The result has a lower bound, below which results count as equal.
INLINE float query_measure(QueryResult* found, int form, float apart)
{
	if (form != QUERY_NEAREST)
	{
		found->fraction = flush_tiny(maximum(found->fraction, apart));
		return maximum(found->fraction, TINY);
	}
	float separation = maximum(found->fraction, 0.0f);
	return maximum(maximum(separation * separation, apart), ABSORBS);
}

// Returns whether result a precedes b, the best result so far, if query_measure is the same for both.
INLINE int query_before(QueryResult a, QueryResult b)
{
	if (!(b.marks & FOUND_HIT) || a.fraction < b.fraction)
		return 1;
	return a.fraction == b.fraction && a.collidable < b.collidable;
}

// Number of results that a CPU worker collects before it adds them to the list. With one result at a time, 16 workers
// take ten times as long, because they wait for each other at the counter. A GPU combines its additions.
#define QUERY_HELD (FETCHES ? 16 : 1)

// Adds the number of results of query i to the counter, and the results to the list while it has room. Returns 1. If
// the counter exceeds QUERY_MOST, adds nothing and returns 0: the list is useless then, and the counter must not
// overflow.
INLINE int query_append(const Pools* p, int i, const QueryResult* held, int count)
{
	GLOBAL QueryPlan* plan = p->query_plan;
	int place = atomic_add_int(&plan->found, count);
	if (place > QUERY_MOST)
	{
		atomic_add_int(&plan->found, -count);
		return 0;
	}
	for (int k = 0; k < count && place + k < plan->room; ++k)
	{
		p->found[place + k] = held[k];
		p->found_query[place + k] = i;
	}
	return 1;
}

#define QUERY_FAR 1.0e7f // m: upper bound of the sum of the absolute components of any query that the host accepts

// Returns whether a query is finite. The host tests this too, but while the device already computes, and it does not
// test queries in shared memory. NaN would hit the empty boxes that pad a node, which have no children.
INLINE int query_finite(Query query)
{
	return absolute(query.a.x) + absolute(query.a.y) + absolute(query.a.z) + absolute(query.a.w) + absolute(query.b.x) +
	           absolute(query.b.y) <
	       QUERY_FAR;
}

// Runs query i. form: QUERY_RAYS, QUERY_SHAPES or QUERY_NEAREST. mode: QUERY_CLOSEST, QUERY_ANY or QUERY_ALL.
INLINE void query_run(const Pools* p, int i, int form, int mode)
{
	const GLOBAL QueryPlan* plan = p->query_plan;
	WorldQuery asked = query_in_world(p, i, form);
	QueryResult best = query_nothing(), held[QUERY_HELD];
	int holds = 0;
	float limit = form == QUERY_NEAREST ? maximum(plan->most * plan->most, ABSORBS) : 1.0f;
	QueryTraversal traversal;
	query_begin(p, &traversal, query_finite(p->query[i]) ? plan->kinds : 0u);
	while (traversal.count > 0)
	{
		--traversal.count;
		if (traversal.apart[traversal.count] > limit)
			continue;
		Word group = traversal.group[traversal.count];
		const GLOBAL Tree* tree = p->tree + (group >> 31);
		int level = (int)(group >> 27 & 15), first = ARITY * (int)(group & 0x7ffffff);
		const GLOBAL Float4* boxes = p->query_box + tree->begin[level] + first;
		float apart[ARITY];
		Word hits = form == QUERY_NEAREST ? apart8(boxes, asked.box, limit, apart)
		                                  : beam8(boxes, asked.sides, asked.inverse, limit, apart);
		if (level > 0)
		{
			query_push(&traversal, hits, apart, query_group((int)(group >> 31), level - 1, first));
			continue;
		}
		for (int k = 0; k < ARITY; ++k)
		{
			if (!(hits >> k & 1) || apart[k] > limit)
				continue;
			QueryLeaf seen = p->query_leaf_row[tree->leaf_begin + first + k];
			QueryResult found = query_nothing();
			if (!query_accepts(p, plan, seen, asked.ignored) || !query_meets(p, seen, &asked, form, &found))
				continue;
			float measure = query_measure(&found, form, apart[k]);
			if (mode == QUERY_ALL)
			{
				held[holds] = found;
				if (++holds < QUERY_HELD)
					continue;
				holds = 0;
				if (query_append(p, i, held, QUERY_HELD))
					continue;
				traversal.count = 0;
				break;
			}
			else if (mode == QUERY_ANY)
			{
				best = query_nothing();
				best.marks = FOUND_HIT;
				traversal.count = 0;
				break;
			}
			else if (measure < limit || (measure == limit && query_before(found, best)))
			{
				best = found;
				limit = measure;
			}
		}
	}
	if (mode != QUERY_ALL)
		p->found[i] = best;
	else if (holds > 0)
		query_append(p, i, held, holds);
}

KERNEL(query_ray) { query_run(p, i, QUERY_RAYS, p->argument); }
KERNEL(query_shape) { query_run(p, i, QUERY_SHAPES, p->argument); }
KERNEL(query_nearest) { query_run(p, i, QUERY_NEAREST, QUERY_CLOSEST); }

// Writes key i of a sort of all results. Upper half: value to sort by (argument: QUERY_BY_*). Lower half: result index.
KERNEL(query_key)
{
	Word place = p->argument == QUERY_BY_COLLIDABLE ? (Word)i : (Word)p->key[i];
	Word by = p->argument == QUERY_BY_COLLIDABLE ? (Word)p->found[place].collidable
	          : p->argument == QUERY_BY_FRACTION ? float_word(p->found[place].fraction)
	                                             : (Word)p->found_query[place];
	p->key[i] = (Word64)by << 32 | (Word64)place;
}

// Writes the results in order, after the sorts.
KERNEL(query_list)
{
	int place = (int)(p->key[i] & (Word64)0xffffffffu);
	p->found_row[i] = p->found[place];
	p->found_row_query[i] = p->found_query[place];
}

#endif
