// SPDX-License-Identifier: MIT
// guard.h -- a body that the solver would move through something static stops inside its surface.
//
// A contact is made before bodies meet, by the velocities at the beginning of a step (sweep.h). A body that is struck or
// turned within the step goes elsewhere, where it may have no contact. So the path of a body that went further than a
// share of its thickness is swept against the static collidables along it: by its own displacement alone, so that no
// order matters. The body moves along its path until it is a little inside the surface. Its velocity stays, and the next
// step has a contact for it.
//
// Such bodies are few, and the work per body is long: finalize lists them for a stage of their own. Within finalize it
// used registers for all bodies of a GPU: 1M in motion took 0.159 ms instead of 0.043 ms on an H200. Several work-items
// share a body of many collidables.
//
// This work is based on:
// Erin Catto, Continuous Collision, GDC 2013: static shapes stop moving ones, at a target inside the surface.
#ifndef GUARD_H
#define GUARD_H
#include "stages/filter.h"
#include "stages/rule.h"
#include "stages/sweep.h"
#include "stages/transform.h"
#include "stages/tree.h"

// of the thickness: how much deeper a body may be at the end of the step than before; and how deep in all, so that its
// middle stays outside
#define GUARD_DEPTH   0.25f
#define GUARD_DEEPEST 0.75f
// m: how much deeper at most; less holds more bodies of a pile, which then overlap more
#define GUARD_MOST 0.015f
// m: how much deeper a body may be that was deeper before; and how closely the target is met
#define GUARD_TOLERANCE (0.1f * SWEEP_DEPTH)

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

// The share of the step after which b is too deep in a: deeper than before by so much, and deeper than deepest, m. normal gets the
// direction from a to b there.
RARE float guard_time(const Pools* p, WorldShape a, Sweep way_a, WorldShape b, Sweep way_b, float deeper, float deepest,
                      Vec* normal)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Closing closing = sweep_between(a, way_a, b, way_b);
	Vec axes = vec(a.c, a.s);
	Frame f = frame_at(vec_turn_back(axes, vec(b.x - a.x, b.y - a.y)), vec_turn_back(axes, vec(b.c, b.s)));
	float time = 0.0f, target = 0.0f;
	for (int round = 0; round < SWEEP_ROUNDS; ++round)
	{
		Manifold m = collide(shape_a, shape_b, f, sweep_reach(closing, axes, time));
		float gap = minimum(m.separation[0], m.separation[1]);
		if (round == 0)
		{
			target = minimum(gap, 0.0f) - deeper;
			target = maximum(target, -deepest);
			target = minimum(target, gap - GUARD_TOLERANCE);
		}
		*normal = vec_turn(axes, m.normal);
		if (m.count > 0 && gap <= target)
			return time;
		float speed = sweep_speed(closing, *normal, time), left = gap - target + GUARD_TOLERANCE;
		if (m.count == 0 || !(speed * (1.0f - time) > left))
			return 1.0f;
		time = time + left / speed;
		sweep_frame(a, b, closing, time, &f);
	}
	return time;
}

// Of what does not move.
INLINE Sweep guard_rest(const GLOBAL Attribute* shape)
{
	Sweep rests;
	rests.path = vec(0.0f, 0.0f);
	rests.center = vec(0.0f, 0.0f);
	rests.turn = 0.0f;
	rests.reach = shape->reach - shape->radius;
	return rests;
}

// The share of its path that collidable i moves, with its body's displacement. Leaves are not in the same order everywhere: of
// equal shares, the lower index counts.
INLINE GuardStop guard_collidable(const Pools* p, int i, Vec path, float turn)
{
	WorldShape world_shape = p->world_shape[i];
	const GLOBAL Attribute* attribute = p->attribute + world_shape.attribute;
	float thickness = p->thickness[world_shape.attribute];
	Sweep way;
	way.path = path;
	way.turn = turn;
	way.center = vec(world_shape.center_x, world_shape.center_y);
	way.reach = attribute->reach - attribute->radius + absolute(way.center.x) + absolute(way.center.y);
	float swing = absolute(turn) * way.reach;
	if (p->collidable_kind[i] & KIND_SENSOR ||
	    !(absolute(path.x) + absolute(path.y) + swing > GUARD_TRAVEL * thickness))
		return guard_stop(1.0f, vec(0.0f, 0.0f), 0);

	Float4 box = world_box(world_shape, attribute, 0.0f);
	Float4 then = make_float4(box.x + path.x, box.y + path.y, box.z + path.x, box.w + path.y);
	box = box_grow(box_union(box, then), swing);
	const GLOBAL Tree* tree = p->tree + 1;
	GuardStop least = guard_stop(1.0f, vec(0.0f, 0.0f), 0);
	TreeWalk walk = tree_walk(p, tree, box, 0, 0, 0x7fffffff);
	for (int first = tree_next(p, tree, box, &walk); first >= 0; first = tree_next(p, tree, box, &walk))
		for (Word64 leaves = walk.leaves; leaves != 0; leaves &= leaves - (Word64)1)
		{
			int j = p->leaf[tree->leaf_begin + first + tree_lowest(leaves)];
			if (p->collidable_kind[j] != KIND_STATIC || !filter_accepts(p->filter[i], p->filter[j]))
				continue;
			if (p->step.joints && joint_parts(p, make_int2(p->collidable_body[i], p->collidable_body[j])))
				continue;
			if (p->step.rules && rule_lets(p, j, i, path, swing))
				continue;
			Vec normal = vec(0.0f, 0.0f);
			WorldShape stands = p->world_shape[j];
			float share = guard_time(p, stands, guard_rest(p->attribute + stands.attribute), world_shape, way,
			                         minimum(GUARD_DEPTH * thickness, GUARD_MOST), GUARD_DEEPEST * thickness, &normal);
			if (share < least.share || (share == least.share && share < 1.0f && j < least.index))
				least = guard_stop(share, normal, j);
		}
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
	for (int k = guard_skip(p, guarded.first, part); k > 0; k = guard_skip(p, k, guarded.parts))
	{
		GuardStop stop = guard_collidable(p, k - 1, path, turn);
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
	return far + swing * guarded.reach > guarded.way && p->tree[1].leaves > 0;
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
