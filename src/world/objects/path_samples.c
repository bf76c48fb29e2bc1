// SPDX-License-Identifier: MIT
// path_samples.c -- computes the samples of a path: a cubic spline through its points, and its arc length. The
// curvature is continuous, so the force on a body that follows the spline has no jumps. The parameter is the sum of the
// distances between successive points. Only + - * / and square roots of doubles are used, so every machine computes the
// same bits. This work is based on: Carl de Boor, A Practical Guide to Splines, 1978: slopes of a spline, and its ends;
// Michael Floater, Chordal Cubic Spline Interpolation is Fourth-Order Accurate, 2006: the parameter.
#include "world/objects/path_samples.h"
#include "world/pool_values.h"
#include <math.h>

#define MOST_TURN 1.0 // rad: maximum of curvature times length to the next sample; cusps have infinite curvature

typedef struct // vector of doubles
{
	double x, y;
} Double2;

typedef struct // equations for the slopes m: before[k] m[k - 1] + own[k] m[k] + behind[k] m[k + 1] = slope[k]
{
	double *before, *own, *behind, *length; // length: distance from each point to the next, m
	Double2 *slope, *wrap;                  // slope: right sides, later the slopes; wrap.x: correction for a ring
} System;

static System system_in(double* work, int count)
{
	size_t n = (size_t)count;
	return (System){work, work + n, work + 2 * n, work + 3 * n, (Double2*)(work + 4 * n), (Double2*)(work + 6 * n)};
}

static Double2 chord(const scree_vec* points, int count, int k)
{
	scree_vec a = points[k], b = points[(k + 1) % count];
	return (Double2){(double)b.x - a.x, (double)b.y - a.y};
}

// Sets up the equations. The second derivative is continuous at inner points; at an end of an open path it equals that
// at the neighboring point.
static void set_up(const scree_vec* points, int count, bool closed, System* s)
{
	for (int k = 0; k < count; ++k)
	{
		Double2 d = chord(points, count, k);
		s->length[k] = sqrt(d.x * d.x + d.y * d.y);
	}
	for (int k = 0; k < count; ++k)
	{
		int last = (k + count - 1) % count;
		double h = s->length[last], g = s->length[k];
		Double2 in = chord(points, count, last), out = chord(points, count, k);
		s->before[k] = g;
		s->own[k] = 2.0 * (h + g);
		s->behind[k] = h;
		s->slope[k] = (Double2){3.0 * (h / g * out.x + g / h * in.x), 3.0 * (h / g * out.y + g / h * in.y)};
	}
	if (closed)
		return;
	int end = count - 1;
	Double2 first = chord(points, count, 0), last = chord(points, count, end - 1);
	double both = count > 2; // two points give a straight line
	s->before[0] = s->behind[end] = 0.0;
	s->own[0] = s->own[end] = 1.0;
	s->behind[0] = s->before[end] = both;
	s->slope[0] = (Double2){(1.0 + both) * first.x / s->length[0], (1.0 + both) * first.y / s->length[0]};
	s->slope[end] = (Double2){(1.0 + both) * last.x / s->length[end - 1], (1.0 + both) * last.y / s->length[end - 1]};
}

// Solves the equations by elimination. For a ring, solves them without the two corner elements of the matrix, then
// corrects the solution for these. Source: Jack Sherman, Winifred Morrison, 1950.
static void solve(int count, bool closed, System* s)
{
	int end = count - 1;
	double corner = closed ? s->before[0] : 0.0, other = closed ? s->behind[end] : 0.0, gamma = -s->own[0];
	for (int k = 0; k < count; ++k)
		s->wrap[k].x = 0.0;
	if (closed)
	{
		s->own[0] -= gamma;
		s->own[end] -= corner * other / gamma;
		s->wrap[0].x = gamma;
		s->wrap[end].x = other;
	}
	for (int k = 1; k < count; ++k)
	{
		double factor = s->before[k] / s->own[k - 1];
		s->own[k] -= factor * s->behind[k - 1];
		s->slope[k].x -= factor * s->slope[k - 1].x;
		s->slope[k].y -= factor * s->slope[k - 1].y;
		s->wrap[k].x -= factor * s->wrap[k - 1].x;
	}
	for (int k = end; k >= 0; --k)
	{
		double behind = k < end ? s->behind[k] : 0.0;
		int next = k < end ? k + 1 : k;
		s->slope[k].x = (s->slope[k].x - behind * s->slope[next].x) / s->own[k];
		s->slope[k].y = (s->slope[k].y - behind * s->slope[next].y) / s->own[k];
		s->wrap[k].x = (s->wrap[k].x - behind * s->wrap[next].x) / s->own[k];
	}
	if (!closed)
		return;
	double share = corner / gamma, below = 1.0 + s->wrap[0].x + share * s->wrap[end].x;
	Double2 first = {(s->slope[0].x + share * s->slope[end].x) / below,
	                 (s->slope[0].y + share * s->slope[end].y) / below};
	for (int k = 0; k < count; ++k)
	{
		s->slope[k].x -= first.x * s->wrap[k].x;
		s->slope[k].y -= first.y * s->wrap[k].x;
	}
}

typedef struct // cubic in t between two points: t is 0 at the first point, 1 at the second
{
	Double2 from, m1, m2, m3;
} Cubic;

static Cubic span_of(const scree_vec* points, int count, const System* s, int k)
{
	Double2 d = chord(points, count, k), m = s->slope[k], n = s->slope[(k + 1) % count];
	double h = s->length[k];
	Cubic c = {.from = {points[k].x, points[k].y}, .m1 = {h * m.x, h * m.y}};
	c.m2 = (Double2){3.0 * d.x - h * (2.0 * m.x + n.x), 3.0 * d.y - h * (2.0 * m.y + n.y)};
	c.m3 = (Double2){h * (m.x + n.x) - 2.0 * d.x, h * (m.y + n.y) - 2.0 * d.y};
	return c;
}

static Double2 speed_at(const Cubic* c, double t)
{
	return (Double2){c->m1.x + t * (2.0 * c->m2.x + 3.0 * t * c->m3.x),
	                 c->m1.y + t * (2.0 * c->m2.y + 3.0 * t * c->m3.y)};
}

static double pace_at(const Cubic* c, double t)
{
	Double2 v = speed_at(c, t);
	return sqrt(v.x * v.x + v.y * v.y);
}

// m: Returns the length of a cubic from t = `from` to `from` + `share`, by Gauss quadrature with three points.
static double length_of(const Cubic* c, double from, double share)
{
	static const double offset = 0.7745966692414834; // sqrt(3 / 5)
	double middle = from + 0.5 * share, aside = 0.5 * share * offset;
	double sum = 5.0 * (pace_at(c, middle - aside) + pace_at(c, middle + aside)) + 8.0 * pace_at(c, middle);
	return share * sum / 18.0;
}

// Returns the sample of a cubic at t. chord_length: distance between its ends, m. along, length: as in PathSample.
static PathSample sample_at(const Cubic* c, double t, double chord_length, double along, double length)
{
	Double2 v = speed_at(c, t), a = {2.0 * c->m2.x + 6.0 * t * c->m3.x, 2.0 * c->m2.y + 6.0 * t * c->m3.y};
	double pace = sqrt(v.x * v.x + v.y * v.y), most = MOST_TURN / length;
	// the derivative is 0 if the curve turns back here; the tangent is then the direction of the chord
	bool stands = !(pace > 1e-6 * chord_length);
	Double2 d = {c->m1.x + c->m2.x + c->m3.x, c->m1.y + c->m2.y + c->m3.y};
	Double2 u = stands ? (Double2){d.x / chord_length, d.y / chord_length} : (Double2){v.x / pace, v.y / pace};
	double bend = stands ? 0.0 : (v.x * a.y - v.y * a.x) / (pace * pace * pace);
	bend = bend > most ? most : bend < -most ? -most : bend;
	PathSample sample = {.x = (float)(c->from.x + t * (c->m1.x + t * (c->m2.x + t * c->m3.x))),
	                     .y = (float)(c->from.y + t * (c->m1.y + t * (c->m2.y + t * c->m3.y))),
	                     .tangent_x = (float)u.x,
	                     .tangent_y = (float)u.y,
	                     .along = (float)along,
	                     .length = (float)length,
	                     .bend = (float)bend};
	FLUSH_MEMBERS(&sample, x, bend);
	return sample;
}

void path_sample(const scree_vec* points, int count, bool closed, double* work, PathSample* samples)
{
	System system = system_in(work, count);
	int spans = path_spans(count, closed);
	double along = 0.0, share = 1.0 / PATH_SHARES, length = 0.0;
	Cubic c = {0};
	set_up(points, count, closed, &system);
	solve(count, closed, &system);
	for (int k = 0; k < spans; ++k)
	{
		c = span_of(points, count, &system, k);
		for (int n = 0; n < PATH_SHARES; ++n, along += length)
		{
			length = length_of(&c, share * n, share);
			samples[PATH_SHARES * k + n] = sample_at(&c, share * n, system.length[k], along, length);
		}
	}
	PathSample* last = samples + PATH_SHARES * spans;
	*last = closed ? samples[0] : sample_at(&c, 1.0, system.length[spans - 1], along, length);
	if (!closed) // the sum of the cubic's terms at t = 1 may be rounded
	{
		last->x = flush_tiny(points[count - 1].x);
		last->y = flush_tiny(points[count - 1].y);
	}
	last->along = (float)along;
	last->length = closed ? samples[0].length : 0.0f;
}
