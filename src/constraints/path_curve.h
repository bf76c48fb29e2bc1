// SPDX-License-Identifier: MIT
// path_curve.h -- computes points, tangents and the nearest point of a curve of samples, on the device and the host.
//
// Between two samples, the curve is the cubic Hermite curve of their points and tangents. The samples are so dense that
// the speed of the curve is nearly constant, so its parameter is a share of the arc length.
#ifndef PATH_CURVE_H
#define PATH_CURVE_H
#include "dialect/vec.h"
#include "pools/pools.h"

typedef struct
{
	const GLOBAL PathSample* samples;
	int segments; // number of samples minus 1
	int closed;
	float length; // m: length of the whole curve
} PathCurve;

typedef struct // a point of a curve
{
	Vec point, tangent;      // m; cos, sin
	float along, bend, sway; // m: arc length; 1/m: curvature; 1/m^2: change of curvature along the curve
} PathFoot;

INLINE PathCurve path_curve(const GLOBAL PathSample* samples, int segments)
{
	PathCurve c;
	c.samples = samples;
	c.segments = segments;
	c.closed = samples[segments].length > 0.0f;
	c.length = samples[segments].along;
	return c;
}

INLINE Vec path_point(const PathCurve* c, int k) { return vec(c->samples[k].x, c->samples[k].y); }
INLINE Vec path_tangent(const PathCurve* c, int k) { return vec(c->samples[k].tangent_x, c->samples[k].tangent_y); }

// m: Returns how far a point is ahead of sample k along the sample's tangent. Above 0, segment k, which begins at
// sample k, is nearer to the point than the segment before.
INLINE float path_ahead(const PathCurve* c, int k, Vec point)
{
	return vec_dot(vec_sub(point, path_point(c, k)), path_tangent(c, k));
}

// Follows the curve from a segment on while the point gets nearer. Returns the segment reached; updates *laps.
INLINE int path_descend(const PathCurve* c, Vec point, int segment, float* laps)
{
	int last = c->segments - 1, forward = path_ahead(c, segment + 1, point) > 0.0f;
	for (int k = 0; k < c->segments; ++k)
	{
		if (forward ? !(path_ahead(c, segment + 1, point) > 0.0f) : !(path_ahead(c, segment, point) < 0.0f))
			break;
		int end = segment == (forward ? last : 0);
		if (end && !c->closed)
			break;
		*laps = *laps + (end ? (forward ? 1.0f : -1.0f) : 0.0f);
		segment = end ? (forward ? 0 : last) : segment + (forward ? 1 : -1);
	}
	return segment;
}

// Clamps t to 0 .. 1; returns 0 for NaN.
INLINE float path_share(float t) { return t > 0.0f ? (t < 1.0f ? t : 1.0f) : 0.0f; }

// Returns the segment whose chord is nearest to a point; of equally near segments, the first.
INLINE int path_nearest(const PathCurve* c, Vec point)
{
	int nearest = 0;
	float least = 0.0f;
	for (int k = 0; k < c->segments; ++k)
	{
		Vec chord = vec_sub(path_point(c, k + 1), path_point(c, k)), from = vec_sub(point, path_point(c, k));
		Vec rest = vec_sub(from, vec_scale(path_share(quotient(vec_dot(from, chord), vec_dot(chord, chord))), chord));
		float square = vec_dot(rest, rest);
		if (k > 0 && !(square < least))
			continue;
		nearest = k;
		least = square;
	}
	return nearest;
}

INLINE int path_segment(const PathCurve* c, float along)
{
	int low = 0, high = c->segments;
	while (high - low > 1)
	{
		int middle = (low + high) / 2;
		if (c->samples[middle].along <= along)
			low = middle;
		else
			high = middle;
	}
	return low;
}

typedef struct // the cubic of a segment, relative to its first sample: m0 t + m2 t^2 + m3 t^3
{
	Vec m0, m2, m3;
} PathCubic;

INLINE PathCubic path_cubic(const PathCurve* c, int segment)
{
	float length = c->samples[segment].length;
	Vec chord = vec_sub(path_point(c, segment + 1), path_point(c, segment));
	Vec m0 = vec_scale(length, path_tangent(c, segment)), m1 = vec_scale(length, path_tangent(c, segment + 1));
	PathCubic cubic;
	cubic.m0 = m0;
	cubic.m2 = vec_sub(vec_scale(3.0f, chord), vec_add(vec_add(m0, m0), m1));
	cubic.m3 = vec_sub(vec_add(m0, m1), vec_add(chord, chord));
	return cubic;
}

INLINE Vec path_cubic_point(const PathCubic* m, float t)
{
	return vec_scale(t, vec_add(m->m0, vec_scale(t, vec_add(m->m2, vec_scale(t, m->m3)))));
}
INLINE Vec path_cubic_speed(const PathCubic* m, float t)
{
	return vec_add(m->m0, vec_scale(t, vec_add(vec_add(m->m2, m->m2), vec_scale(3.0f * t, m->m3))));
}

// Returns the point of a segment at `t`, a share of the segment's length from 0 to 1.
INLINE PathFoot path_foot_at(const PathCurve* c, int segment, float t)
{
	const GLOBAL PathSample *from = c->samples + segment, *to = from + 1;
	PathCubic cubic = path_cubic(c, segment);
	Vec speed = path_cubic_speed(&cubic, t);
	float square = vec_dot(speed, speed);
	PathFoot foot;
	foot.point = vec_add(path_point(c, segment), path_cubic_point(&cubic, t));
	foot.tangent = square > 0.0f ? vec_scale(quotient(1.0f, root(square)), speed) : path_tangent(c, segment);
	foot.along = from->along + t * from->length;
	foot.bend = from->bend + t * (to->bend - from->bend);
	foot.sway = quotient(to->bend - from->bend, from->length);
	return foot;
}

// Returns the nearest point of a segment, found by a secant step and two steps of Newton's method. The remaining error
// lies along the curve and has no effect. An open curve continues beyond its ends as a straight line.
INLINE PathFoot path_foot(const PathCurve* c, int segment, Vec point)
{
	float before = path_ahead(c, segment, point), behind = path_ahead(c, segment + 1, point);
	float t = path_share(quotient(before, before - behind));
	PathCubic cubic = path_cubic(c, segment);
	Vec from = vec_sub(point, path_point(c, segment));
	for (int k = 0; k < 2; ++k)
	{
		Vec rest = vec_sub(from, path_cubic_point(&cubic, t)), speed = path_cubic_speed(&cubic, t);
		Vec bends = vec_add(vec_add(cubic.m2, cubic.m2), vec_scale(6.0f * t, cubic.m3));
		float slope = vec_dot(speed, speed) - vec_dot(rest, bends);
		t = slope > 0.0f ? path_share(t + quotient(vec_dot(rest, speed), slope)) : t;
	}
	PathFoot foot = path_foot_at(c, segment, t);
	if (!c->closed && ((segment == 0 && before < 0.0f) || (segment == c->segments - 1 && behind > 0.0f)))
		foot.bend = foot.sway = 0.0f;
	return foot;
}

INLINE float path_distance(const PathFoot* foot, Vec point)
{
	Vec d = vec_sub(point, foot->point);
	return root(vec_dot(d, d));
}

#endif
