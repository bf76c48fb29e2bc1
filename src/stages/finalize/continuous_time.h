// SPDX-License-Identifier: MIT
// continuous_time.h -- computes when two collidables get too deep into each other, from their motions in the step.
//
// This work is based on:
// Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996: conservative advancement. Here each
// corner has its own speed, and all share a bound of their acceleration (docs/design/continuous.md).
#ifndef CONTINUOUS_TIME_H
#define CONTINUOUS_TIME_H
#include "stages/geometry/sweep.h"

#define CONTINUOUS_TOLERANCE (0.1f * SWEEP_DEPTH) // m: tolerance of the target depth

typedef struct // first time at which two collidables a and b are too deep in each other
{
	float time; // fraction of the step; 1 if they are never too deep
	Vec normal; // direction from a to b at that time, in the world
	Vec point;  // deepest point at that time, from the origin of b, m
} ContinuousMeeting;

// m per step^2: Returns the acceleration of the smaller collidable at `time`, in the rotating frame of the larger one.
INLINE Vec continuous_bend(Closing c, float time)
{
	float frame = c.b.reach < c.a.reach ? c.a.turn : c.b.turn;
	return vec_sub(c.bend, vec_spin(frame, vec_add(c.near, vec_scale(time, c.bend))));
}

// Returns the result of sweep_reach, with `swing` enlarged by the largest distance of curved paths from their tangents.
INLINE Reach continuous_reach(Closing c, Vec axes, float time)
{
	Reach reach = sweep_reach(c, axes, time);
	Vec bend = continuous_bend(c, time);
	float left = 1.0f - time;
	reach.swing += 0.5f * left * left * (absolute(bend.x) + absolute(bend.y));
	return reach;
}

// Returns a duration after `time`, as a fraction of the step and at most 2, in which no point of the smaller collidable
// approaches the larger one along a normal by more than its gap. left, m: gap of the deepest point.
INLINE float continuous_advance(const Pools* p, WorldShape a, WorldShape b, Closing c, Vec normal, float time,
                                float left)
{
	int first = c.a.reach < c.b.reach || c.a.reach == c.b.reach; // 1 if shape a is the smaller one
	WorldShape shape = first ? a : b;
	Sweep way = first ? c.a : c.b;
	const GLOBAL Attribute* attribute = p->attribute + shape.attribute;
	float spin = c.b.turn - c.a.turn, side = first ? -1.0f : 1.0f;
	Vec turn = vec_rotation(time * way.turn), axes = vec_turn(turn, vec(shape.c, shape.s));
	Vec center = vec_turn(turn, way.center);
	float closes = -vec_dot(normal, vec_add(c.near, vec_scale(time, c.bend)));
	float most = spin * spin * way.reach + maximum(-vec_dot(normal, continuous_bend(c, time)), 0.0f);
	float low = NO_POINT, soon = 2.0f;
	for (int k = 0; k < attribute->count; ++k)
		low = minimum(low, side * vec_dot(normal, vec_turn(axes, shape_corner(attribute, k))));
	for (int k = 0; k < attribute->count; ++k)
	{
		Vec corner = vec_turn(axes, shape_corner(attribute, k));
		float gap = left + (side * vec_dot(normal, corner) - low);
		float speed = closes - vec_dot(normal, vec_spin(spin, vec_sub(corner, center)));
		// t = 2 gap / twice is the solution of speed t + most t^2 / 2 = gap
		float twice = speed + square_root(speed * speed + 2.0f * most * gap);
		if (twice > gap)
			soon = minimum(soon, quotient(2.0f * gap, twice));
	}
	return soon;
}

#define CONTINUOUS_SLIDES 1.0e-5f // fraction of the relative motion; a point that approaches by less only slides

// Returns 1 if a manifold has a point whose depth is at least `deep`, m, and increases; otherwise 0.
INLINE int continuous_sinks(Closing c, Manifold m, Vec axes, Vec position, float deep)
{
	Vec normal = vec_turn(axes, m.normal);
	float still =
	    CONTINUOUS_SLIDES * (absolute(c.near.x) + absolute(c.near.y) + absolute(c.b.turn - c.a.turn) * c.b.reach);
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		Vec arm = vec_sub(vec_turn(axes, vec_sub(m.point[k], position)), c.b.center);
		if (m.separation[k] <= -deep && vec_dot(normal, vec_add(c.near, vec_spin(c.b.turn, arm))) < -still)
			return 1;
	}
	return 0;
}

typedef struct // limits of the depth of shape b in shape a, m
{
	float deeper;  // limit of the increase since the start of the step
	float deepest; // limit of the total depth
	float slack;   // increase that is always allowed
	float pressed; // if b is pressed into a static shape a: depth beyond which b must not get deeper; else 0
} ContinuousDepth;

// Returns an upper bound of the distance, m, by which the path of a point of b, in the rotating frame of a, leaves the
// straight line from its start to its end: an eighth of the point's largest acceleration, m per step^2.
INLINE float continuous_bow(Closing c, Vec between)
{
	Vec apart = vec_sub(c.b.path, c.a.path);
	float turn = absolute(c.a.turn), spin = c.b.turn - c.a.turn, far = absolute(apart.x) + absolute(apart.y);
	float arm =
	    absolute(between.x + (c.b.center.x - c.a.center.x)) + absolute(between.y + (c.b.center.y - c.a.center.y));
	return 0.125f * (turn * (turn * (arm + far) + 2.0f * far) + spin * spin * c.b.reach);
}

typedef struct // side of a shape, in the frame of the shape
{
	Vec normal;
	float surface; // m: distance of the surface from the origin of the frame, along the normal
} ContinuousSide;

// Returns the side of a shape with the largest signed distance (positive: outside) to a point in the shape's frame.
INLINE ContinuousSide continuous_side(const GLOBAL Attribute* shape, Vec point)
{
	ContinuousSide side;
	Vec corner = shape_corner(shape, 0), away = vec_sub(point, corner);
	if (shape->count == 1)
	{
		float distance = square_root(vec_dot(away, away));
		side.normal = distance > CENTERS_APART ? vec_scale(quotient(1.0f, distance), away) : vec(0.0f, 1.0f);
	}
	else
	{
		side.normal = shape_normal(shape, 0);
		float most = vec_dot(side.normal, away);
		for (int k = 1; k < shape->count; ++k)
		{
			Vec normal = shape_normal(shape, k), from = shape_corner(shape, k);
			float far = vec_dot(normal, vec_sub(point, from));
			if (far > most)
			{
				most = far;
				side.normal = normal;
				corner = from;
			}
		}
	}
	side.surface = vec_dot(side.normal, corner) + shape->radius;
	return side;
}

// Returns whether shape b stays less than `deep`, m, below one side of shape a (continuous_side) on the whole path, so
// that the two cannot get too deep into each other. This holds for most pairs. Between the ends of its path, a corner
// gets lower than both ends by at most continuous_bow.
RARE int continuous_passes(const Pools* p, WorldShape a, Sweep way_a, WorldShape b, Sweep way_b, float deep)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Closing closing = sweep_between(a, way_a, b, way_b);
	Vec axes = vec(a.c, a.s), between = vec(b.x - a.x, b.y - a.y);
	Frame begin = frame_at(vec_turn_back(axes, between), vec_turn_back(axes, vec(b.c, b.s))), end;
	end.position = vec_add(begin.position, vec_turn_back(axes, vec_sub(way_b.path, way_a.path)));
	end.rotation = begin.rotation;
	if (way_a.turn != 0.0f || way_b.turn * way_b.reach != 0.0f)
		sweep_frame(a, b, closing, 1.0f, &end);
	Vec opposite = shape_corner(shape_b, shape_b->count / 2);
	Vec middle = vec_scale(0.5f, vec_add(shape_corner(shape_b, 0), opposite));
	ContinuousSide side = continuous_side(shape_a, frame_point(begin, middle));
	Vec at_begin = vec_turn_back(begin.rotation, side.normal), at_end = vec_turn_back(end.rotation, side.normal);
	float low_begin = -NO_AXIS, low_end = -NO_AXIS;
	for (int k = 0; k < shape_b->count; ++k)
	{
		Vec corner = shape_corner(shape_b, k);
		low_begin = minimum(low_begin, vec_dot(at_begin, corner));
		low_end = minimum(low_end, vec_dot(at_end, corner));
	}
	float low = minimum(vec_dot(side.normal, begin.position) + low_begin, vec_dot(side.normal, end.position) + low_end);
	return low - side.surface - shape_b->radius - continuous_bow(closing, between) > -deep;
}

RARE ContinuousMeeting continuous_time(const Pools* p, WorldShape a, Sweep way_a, WorldShape b, Sweep way_b,
                                       ContinuousDepth deep)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Closing closing = sweep_between(a, way_a, b, way_b);
	Vec start = vec(a.c, a.s), axes = start;
	Frame f = frame_at(vec_turn_back(axes, vec(b.x - a.x, b.y - a.y)), vec_turn_back(axes, vec(b.c, b.s)));
	float target = 0.0f;
	ContinuousMeeting met;
	met.time = 0.0f;
	for (int round = 0; round < SWEEP_ROUNDS; ++round)
	{
		Manifold m = collide(shape_a, shape_b, f, continuous_reach(closing, axes, met.time));
		float gap = minimum(m.separation[0], m.separation[1]);
		if (round == 0)
		{
			target = minimum(gap, 0.0f) - deep.deeper;
			target = maximum(target, -deep.deepest);
			target = minimum(target, gap - deep.slack);
			if (deep.pressed > 0.0f)
				target = minimum(-deep.pressed, continuous_sinks(closing, m, axes, f.position, deep.pressed)
				                                    ? gap
				                                    : gap - CONTINUOUS_TOLERANCE);
		}
		met.normal = vec_turn(axes, m.normal);
		// constant indices keep the manifold in registers
		int second = m.separation[1] < m.separation[0];
		Vec deepest = vec(second ? m.point[1].x : m.point[0].x, second ? m.point[1].y : m.point[0].y);
		met.point = vec_turn(axes, vec_sub(deepest, f.position));
		if (m.count > 0 && gap <= target)
			return met;
		if (m.count > 0)
			met.time += continuous_advance(p, a, b, closing, met.normal, met.time, gap - target + CONTINUOUS_TOLERANCE);
		if (m.count == 0 || !(met.time < 1.0f))
			break;
		axes = vec_turn(sweep_frame(a, b, closing, met.time, &f), start);
		if (round + 1 == SWEEP_ROUNDS)
			return met;
	}
	met.time = 1.0f;
	return met;
}

#endif
