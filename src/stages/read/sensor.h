// SPDX-License-Identifier: MIT
// sensor.h -- finds the collidables that overlapped a sensor at some time of the step.
//
// A visit is computed for a motion at constant speed between the poses at the start and the end of the step. With the
// velocities instead, a body would also be found behind a wall from which it bounces (docs/manual/events.md).
//
// This work is based on:
// Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996: conservative advancement.
#ifndef SENSOR_H
#define SENSOR_H
#include "constraints/angle.h"
#include "stages/geometry/convex_sum.h"
#include "stages/geometry/sweep.h"
#include "stages/read/query_tree.h"
#include "stages/rules/apart.h"

#define SENSOR_DEPTH (0.05f * LINEAR_SLOP) // m: a smaller overlap that ends within the step does not count
// maximum number of rounds of conservative advancement. In the second half, each round advances by at least its
// share of the rest of the step; beside something that rotates fast, a visit shorter than this share may be missed
#define SENSOR_ROUNDS   64
#define SENSOR_HALVINGS 10    // rounds that halve the interval in which a visit began
#define SENSOR_ROUNDING 1e-6f // bound of rounding errors of positions, as a fraction of the reaches of two shapes
#define SENSOR_NEVER    2.0f  // result for pairs that do not overlap: a time after the end of the step

INLINE Sweep sensor_sweep(const Pools* p, WorldShape from, WorldShape to)
{
	const GLOBAL Attribute* shape = p->attribute + from.attribute;
	Sweep s;
	s.center = vec(from.center_x, from.center_y);
	s.path = vec((to.x - from.x) + (to.center_x - from.center_x), (to.y - from.y) + (to.center_y - from.center_y));
	s.turn = vec_angle(vec_turn_back(vec(from.c, from.s), vec(to.c, to.s)));
	s.reach = shape->reach - shape->radius + absolute(s.center.x) + absolute(s.center.y);
	return s;
}

// Returns the separation of two collidables. f: pose of shape b in the frame of shape a. *normal: toward b, in this
// frame. If this function were inlined, gcc would not inline the narrow phase (1.2 % more instructions in storm).
RARE float sensor_apart(const Pools* p, WorldShape a, WorldShape b, Frame f, Vec* normal)
{
	const GLOBAL Attribute *shape_a = p->attribute + a.attribute, *shape_b = p->attribute + b.attribute;
	Sum sum;
	sum_make(shape_a, shape_b, f.rotation, &sum);
	Convex convex = sum_convex(&sum, shape_a->radius + shape_b->radius);
	ConvexNearest n = convex_nearest(&convex, f.position);
	*normal = n.normal;
	return n.separation;
}

INLINE Frame sensor_frame(WorldShape a, WorldShape b)
{
	Vec axes = vec(a.c, a.s);
	return frame_at(vec_turn_back(axes, vec(b.x - a.x, b.y - a.y)), vec_turn_back(axes, vec(b.c, b.s)));
}

// Returns whether corner 0 of shape b is well inside shape a, as for most visitors of a large sensor; then the shapes
// overlap. The margin exceeds rounding errors, so the result is never 1 if the separation is positive.
INLINE int sensor_within(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Frame f)
{
	Vec corner = frame_point(f, shape_corner(b, 0));
	float margin = SENSOR_DEPTH + SENSOR_ROUNDING * (a->reach + b->reach);
	if (a->count == 1)
	{
		Vec from = vec_sub(corner, shape_corner(a, 0));
		float radius = a->radius - margin;
		return radius > 0.0f && vec_dot(from, from) < radius * radius;
	}
	for (int k = 0; k < a->count; ++k)
		if (vec_dot(shape_normal(a, k), vec_sub(corner, shape_corner(a, k))) > -margin)
			return 0;
	return 1;
}

typedef struct // bounds of the speed at which two collidables approach at any time of the step, m per step
{
	Vec path;    // motion of collidable b relative to collidable a, without the rotations
	float turns; // bound of the speed that the rotations of the two bodies add to their points
	float along; // bound in the rotating frame of the larger collidable: small if both collidables rotate together
} SensorPace;

// Returns the bounds for a pair. In the frame of a body that rotates by w, a velocity u changes by at most |w| |path| +
// |w| |u| per step, so it stays below e^|w| (|u| + |w| |path|). Up to 1.7 rad, 1 + |w| + w^2 exceeds e^|w|.
INLINE SensorPace sensor_pace(Closing c)
{
	SensorPace pace;
	pace.path = vec_sub(c.b.path, c.a.path);
	pace.turns = absolute(c.a.turn) * c.a.reach + absolute(c.b.turn) * c.b.reach;
	float w = absolute(c.b.reach < c.a.reach ? c.a.turn : c.b.turn);
	float near = root(vec_dot(c.near, c.near)) + w * root(vec_dot(pace.path, pace.path));
	pace.along = w < 1.7f ? (1.0f + w + w * w) * near + c.swing : NO_POINT;
	return pace;
}

// Returns an upper bound of the speed at which two points approach along a normal.
INLINE float sensor_speed(SensorPace pace, Vec normal)
{
	return minimum(pace.turns - vec_dot(normal, pace.path), pace.along);
}

// Returns the time at which two moving collidables first overlap, SENSOR_NEVER if they do not. Each advance aims at an
// overlap of SENSOR_DEPTH. A slow pair reaches it long after it meets, so the time of separation 0 is interpolated.
RARE float sensor_time(const Pools* p, WorldShape a, WorldShape b, Closing closing)
{
	SensorPace pace = sensor_pace(closing);
	float time = 0.0f, before = 0.0f, gap_before = 0.0f, met = SENSOR_NEVER;
	int past = 0, halvings = 0; // past: an advance may have passed the beginning of the overlap
	for (int round = 0; round < SENSOR_ROUNDS + SENSOR_HALVINGS; ++round)
	{
		Frame f;
		Vec normal, axes = vec_turn(sweep_frame(a, b, closing, time, &f), vec(a.c, a.s));
		float gap = sensor_apart(p, a, b, f, &normal);
		if (gap <= 0.0f)
		{
			met = time;
			if (!past)
				return gap_before > 0.0f ? before + (time - before) * quotient(gap_before, gap_before - gap) : time;
		}
		else
		{
			before = time;
			gap_before = gap;
		}
		if (met <= 1.0f)
		{
			if (++halvings > SENSOR_HALVINGS)
				break;
			time = 0.5f * (before + met);
			continue;
		}
		float speed = sensor_speed(pace, vec_turn(axes, normal)), left = gap + SENSOR_DEPTH;
		if (round >= SENSOR_ROUNDS || !(speed * (1.0f - time) > gap))
			break;
		float share = round < SENSOR_ROUNDS / 2 ? 0.0f : quotient(1.0f - time, (float)(SENSOR_ROUNDS - round));
		past = share * speed > left;
		time = minimum(time + maximum(quotient(left, speed), share), 1.0f);
	}
	return met;
}

// Returns whether two collidables overlap well at the start and at the end of the step, which is found fast. a, b: poses at
// the end; end: frame of this pair.
INLINE int sensor_stays(const Pools* p, int sensor, WorldShape a, int visitor, WorldShape b, Frame end)
{
	const GLOBAL Attribute *shape_a = p->attribute + a.attribute, *shape_b = p->attribute + b.attribute;
	return sensor_within(shape_a, shape_b, end) &&
	       sensor_within(shape_a, shape_b, sensor_frame(p->world_shape[sensor], p->world_shape[visitor]));
}

// Returns whether a leaf visits a sensor. Sets visit->fraction and visit->x to the times at which the visit begins and
// ends; x is 1 if it lasts. a: pose of the sensor at the end of the step.
INLINE int sensor_visit(const Pools* p, int sensor, WorldShape a, QueryLeaf seen, QueryResult* visit)
{
	WorldShape b = collidable_place(p, seen.collidable), start_a = p->world_shape[sensor],
	           start_b = p->world_shape[seen.collidable];
	Frame end = sensor_frame(a, b);
	visit->collidable = seen.collidable;
	visit->fraction = 0.0f;
	visit->x = 1.0f;
	visit->marks = FOUND_HIT | FOUND_INSIDE;
	if (sensor_stays(p, sensor, a, seen.collidable, b, end))
		return 1;
	Vec normal;
	float apart = sensor_apart(p, a, b, end, &normal);
	Sweep sa = sensor_sweep(p, start_a, a), sb = sensor_sweep(p, start_b, b);
	Closing closing = sweep_between(start_a, sa, start_b, sb);
	SensorPace pace = sensor_pace(closing);
	if (apart > minimum(pace.turns + root(vec_dot(pace.path, pace.path)), pace.along))
		return 0;
	int moves = pace.turns > 0.0f || pace.path.x != 0.0f || pace.path.y != 0.0f;
	float begin = moves ? sensor_time(p, start_a, start_b, closing) : 0.0f, left = 1.0f;
	if (apart > 0.0f)
	{
		if (begin > 1.0f)
			return 0;
		float back =
		    sensor_time(p, a, b, sweep_between(a, sensor_sweep(p, a, start_a), b, sensor_sweep(p, b, start_b)));
		left = back > 1.0f ? begin : maximum(1.0f - back, begin);
	}
	visit->fraction = flush_tiny(minimum(begin, 1.0f));
	visit->x = flush_tiny(left);
	visit->marks = FOUND_HIT | (apart > 0.0f ? 0u : FOUND_INSIDE);
	return 1;
}

// Returns the kinds that a sensor detects, as bits of QueryLeaf.kinds.
INLINE Word sensor_kinds(Word bits)
{
	const Word moving = 1u << (KIND_DYNAMIC - 1) | 1u << (KIND_KINEMATIC - 1);
	const Word still = 1u << (KIND_STATIC - 1) | 1u << (KIND_FREE - 1);
	return (bits & SENSOR_MOVING ? moving : 0u) | (bits & SENSOR_STATIC ? still : 0u) |
	       (bits & SENSOR_SENSORS ? LEAF_SENSOR : 0u);
}

typedef struct // search for the visits of a sensor
{
	int query, sensor;
	Word kinds;
	WorldShape at; // pose of the sensor at the end of the step
	Float4 box;    // box around the motion of the sensor
	int blocks[2]; // range of blocks of eight leaves, end excluded
} SensorSearch;

INLINE void sensor_leaf(const Pools* p, const SensorSearch* s, QueryLeaf seen)
{
	QueryResult visit = query_nothing();
	if ((seen.kinds & s->kinds) && seen.collidable != s->sensor &&
	    !apart_by(p, s->sensor, seen.collidable, APART_SEEN) && sensor_visit(p, s->sensor, s->at, seen, &visit))
		query_append(p, s->query, &visit, 1);
}

// Returns whether some leaves below a node of a level are in the searched range. Node n of level 1 covers block n.
INLINE int sensor_covers(const SensorSearch* s, int level, int node)
{
	int bits = ARITY_BITS * (level - 1);
	return node << bits < s->blocks[1] && (node + 1) << bits > s->blocks[0];
}

// Lists the visits of the leaves of tree t.
INLINE void sensor_tree(const Pools* p, const SensorSearch* s, int t)
{
	const GLOBAL Tree* tree = p->tree + t;
	QueryTraversal traversal;
	traversal.group[0] = query_group(t, tree->top, 0);
	traversal.count = 1;
	while (traversal.count > 0)
	{
		Word group = traversal.group[--traversal.count];
		int level = (int)(group >> 27 & 15), first = ARITY * (int)(group & 0x7ffffff);
		Word hits = overlaps8(p->query_box + tree->begin[level] + first, s->box);
		for (int k = 0; k < ARITY; ++k)
		{
			if (!(hits >> k & 1))
				continue;
			if (level == 0)
				sensor_leaf(p, s, p->query_leaf_row[tree->leaf_begin + first + k]);
			else if (sensor_covers(s, level, first + k))
				traversal.group[traversal.count++] = query_group(t, level - 1, first + k);
		}
	}
}

// Item: part i % argument of the search for the visits of the sensor in query i / argument. argument: number of parts.
// Each part searches some of the leaves; otherwise a sensor as large as the world would keep one work-item busy.
KERNEL(sensor_overlap)
{
	SensorSearch s;
	int parts = p->argument, part = i % parts;
	s.query = i / parts;
	s.sensor = p->query[s.query].ignored_generation;
	Word reports = p->filter[s.sensor].reports;
	if (p->collidable_kind[s.sensor] == KIND_DEAD || !(reports & SENSOR_BITS))
		return;
	s.kinds = sensor_kinds(reports);
	s.at = collidable_place(p, s.sensor);
	s.box = query_way_box(p, s.sensor, s.at);
	for (int t = 0; t < 2; ++t)
	{
		int leaves = p->tree[t].leaves, share = ((leaves + ARITY - 1) / ARITY + parts - 1) / parts;
		s.blocks[0] = share * part;
		s.blocks[1] = s.blocks[0] + share;
		if (leaves > 0 && ARITY * s.blocks[0] < leaves && (s.kinds & query_kinds(t)))
			sensor_tree(p, &s, t);
	}
}

#endif
