// SPDX-License-Identifier: MIT
// sense.h -- what sensors see: the collidables that overlapped them at some time of the step.
//
// A visit is judged by the way that both went from the beginning of the step to its end, at constant speed: not by velocities, so
// what bounces off a wall before a sensor is not seen behind it. What overlaps at the end is tested at the poses of the end.
//
// This work is based on:
// Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996: conservative advancement.
#ifndef SENSE_H
#define SENSE_H
#include "constraints/angle.h"
#include "stages/convex_sum.h"
#include "stages/query_tree.h"
#include "stages/sweep.h"

// m: shapes that overlap by less within the step alone have not met
#define SENSE_DEPTH (0.05f * LINEAR_SLOP)
// rounds of conservative advancement. From half of them on each goes on by at least its share of what is left of the step: where
// something turns fast close beside a sensor, a visit may be missed that is shorter
#define SENSE_ROUNDS 64
// later than any time of a step
#define SENSE_NEVER 2.0f

// The way of a collidable in the step, from one pose to another one.
INLINE Sweep sense_sweep(const Pools* p, WorldShape from, WorldShape to)
{
	const GLOBAL Attribute* shape = p->attribute + from.attribute;
	Sweep s;
	s.center = vec(from.center_x, from.center_y);
	s.path = vec((to.x - from.x) + (to.center_x - from.center_x), (to.y - from.y) + (to.center_y - from.center_y));
	s.turn = vec_angle(vec_turn_back(vec(from.c, from.s), vec(to.c, to.s)));
	s.reach = shape->reach - shape->radius + absolute(s.center.x) + absolute(s.center.y);
	return s;
}

// The separation of two collidables in a frame, with the normal from a to b in the frame of a.
INLINE float sense_apart(const Pools* p, WorldShape a, WorldShape b, Frame f, Vec* normal)
{
	const GLOBAL Attribute *shape_a = p->attribute + a.attribute, *shape_b = p->attribute + b.attribute;
	Sum sum;
	sum_make(shape_a, shape_b, f.rotation, &sum);
	Convex convex = sum_convex(&sum, shape_a->radius + shape_b->radius);
	ConvexNearest n = convex_nearest(&convex, f.position);
	*normal = n.normal;
	return n.separation;
}

typedef struct // bounds of how fast two collidables draw near at any time of the step, m per step
{
	Vec path;    // of b against a, without the turns
	float turns; // by which points move because their bodies turn
	float along; // for points seen from the larger one, which turns: small where both turn together
} SensePace;

// Seen from a body that turns by w, a velocity u changes by |w| |path| + |w| |u| at most per step, so it stays below
// e^|w| (|u| + |w| |path|); up to 1.7 rad, 1 + |w| + w^2 is more than that power.
INLINE SensePace sense_pace(Closing c)
{
	SensePace pace;
	pace.path = vec_sub(c.b.path, c.a.path);
	pace.turns = absolute(c.a.turn) * c.a.reach + absolute(c.b.turn) * c.b.reach;
	float w = absolute(c.b.reach < c.a.reach ? c.a.turn : c.b.turn);
	float near = root(vec_dot(c.near, c.near)) + w * root(vec_dot(pace.path, pace.path));
	pace.along = w < 1.7f ? (1.0f + w + w * w) * near + c.swing : NO_POINT;
	return pace;
}

// The most by which two points may draw near along a normal.
INLINE float sense_speed(SensePace pace, Vec normal)
{
	return minimum(pace.turns - vec_dot(normal, pace.path), pace.along);
}

// The time at which two collidables first overlap on their ways, SENSE_NEVER if they do not.
INLINE float sense_time(const Pools* p, WorldShape a, WorldShape b, Closing closing)
{
	SensePace pace = sense_pace(closing);
	float time = 0.0f;
	for (int round = 0; round < SENSE_ROUNDS; ++round)
	{
		Frame f;
		Vec normal, axes = vec_turn(sweep_frame(a, b, closing, time, &f), vec(a.c, a.s));
		float gap = sense_apart(p, a, b, f, &normal);
		if (gap <= 0.0f)
			return time;
		float speed = sense_speed(pace, vec_turn(axes, normal)), left = gap + SENSE_DEPTH;
		if (!(speed * (1.0f - time) > left))
			break;
		float share = round < SENSE_ROUNDS / 2 ? 0.0f : (1.0f - time) / (float)(SENSE_ROUNDS - round);
		time = minimum(time + maximum(left / speed, share), 1.0f);
	}
	return SENSE_NEVER;
}

// The visit of leaf b to sensor a, both at their poses of the end, if there is one: when it began and ended, and whether it lasts.
INLINE int sense_visit(const Pools* p, int sensor, WorldShape a, Seen seen, Found* visit)
{
	WorldShape b = collidable_place(p, seen.collidable), start_a = p->world_shape[sensor],
	           start_b = p->world_shape[seen.collidable];
	Vec axes = vec(a.c, a.s), normal;
	Frame end = frame_at(vec_turn_back(axes, vec(b.x - a.x, b.y - a.y)), vec_turn_back(axes, vec(b.c, b.s)));
	float apart = sense_apart(p, a, b, end, &normal);
	Sweep sa = sense_sweep(p, start_a, a), sb = sense_sweep(p, start_b, b);
	Closing closing = sweep_between(start_a, sa, start_b, sb);
	SensePace pace = sense_pace(closing);
	if (apart > minimum(pace.turns + root(vec_dot(pace.path, pace.path)), pace.along))
		return 0;
	float begin = sense_time(p, start_a, start_b, closing), left = 1.0f;
	if (apart > 0.0f)
	{
		if (begin > 1.0f)
			return 0;
		float back = sense_time(p, a, b, sweep_between(a, sense_sweep(p, a, start_a), b, sense_sweep(p, b, start_b)));
		left = back > 1.0f ? begin : maximum(1.0f - back, begin);
	}
	visit->collidable = seen.collidable;
	visit->fraction = minimum(begin, 1.0f);
	visit->x = left;
	visit->marks = FOUND_HIT | (apart > 0.0f ? 0u : FOUND_INSIDE);
	return 1;
}

// The kinds that a sensor sees, as bits of Seen.kinds.
INLINE Word sense_kinds(Word bits)
{
	const Word moving = 1u << (KIND_DYNAMIC - 1) | 1u << (KIND_KINEMATIC - 1);
	const Word still = 1u << (KIND_STATIC - 1) | 1u << (KIND_FREE - 1);
	return (bits & SENSOR_MOVING ? moving : 0u) | (bits & SENSOR_STATIC ? still : 0u) |
	       (bits & SENSOR_SENSORS ? SEEN_SENSOR : 0u);
}

// Item i is a sensor: the collidable in query i.
STAGE(sense)
{
	int sensor = p->query[i].ignored_generation, body = p->collidable_body[sensor];
	Filter filter = p->filter[sensor];
	if (p->collidable_kind[sensor] == KIND_DEAD || !(filter.reports & SENSOR_BITS))
		return;
	Word kinds = sense_kinds(filter.reports);
	WorldShape at = collidable_place(p, sensor);
	Float4 box = query_way_box(p, sensor, at);
	QueryWalk walk;
	query_begin(p, &walk, kinds);
	while (walk.count > 0)
	{
		Word group = walk.group[--walk.count];
		const GLOBAL Tree* tree = p->tree + (group >> 31);
		int level = (int)(group >> 27 & 15), first = ARITY * (int)(group & 0x7ffffff);
		Word hits = overlaps8(p->seen_box + tree->begin[level] + first, box);
		for (int k = 0; k < ARITY; ++k)
		{
			if (!(hits >> k & 1))
				continue;
			if (level > 0)
			{
				walk.group[walk.count++] = query_group((int)(group >> 31), level - 1, first + k);
				continue;
			}
			Seen seen = p->seen[tree->leaf_begin + first + k];
			Found visit = query_nothing();
			if (!(seen.kinds & kinds) || seen.collidable == sensor || (body >= 0 && seen.body == body) ||
			    !filter_accepts(filter, p->filter[seen.collidable]) || !sense_visit(p, sensor, at, seen, &visit))
				continue;
			query_append(p, i, &visit, 1);
		}
	}
}

#endif
