// SPDX-License-Identifier: MIT
// exact_shapes.c -- computes distances and meetings of shapes in double precision, from all pairs of corners and edges.
#include "support/exact_shapes.h"
#include <math.h>

Exact exact_at(const scree_shape* shape, double x, double y, double c, double s)
{
	Exact e = {.count = shape->count, .radius = shape->radius};
	for (int k = 0; k < shape->count; ++k)
	{
		e.x[k] = x + c * (double)shape->vertices[k].x - s * (double)shape->vertices[k].y;
		e.y[k] = y + s * (double)shape->vertices[k].x + c * (double)shape->vertices[k].y;
	}
	return e;
}

Exact exact_moved(Exact e, double x, double y)
{
	for (int k = 0; k < e.count; ++k)
	{
		e.x[k] += x;
		e.y[k] += y;
	}
	return e;
}

// Returns the largest separation of shape b from shape a along the normals of the edges of shape a.
static double exact_axes(const Exact* a, const Exact* b)
{
	double most = -INFINITY;
	for (int k = 0; a->count > 1 && k < a->count; ++k)
	{
		int next = (k + 1) % a->count;
		double ex = a->x[next] - a->x[k], ey = a->y[next] - a->y[k], length = hypot(ex, ey), least = INFINITY;
		for (int i = 0; i < b->count; ++i)
			least = fmin(least, ((b->x[i] - a->x[k]) * ey - (b->y[i] - a->y[k]) * ex) / length);
		most = fmax(most, least);
	}
	return most;
}

// Returns the smallest distance of a corner of shape b from an edge of shape a.
static double exact_corners(const Exact* a, const Exact* b)
{
	double least = INFINITY;
	for (int i = 0; i < b->count; ++i)
		for (int k = 0; k < a->count; ++k)
		{
			int next = (k + 1) % a->count;
			double ex = a->x[next] - a->x[k], ey = a->y[next] - a->y[k], square = ex * ex + ey * ey;
			double px = b->x[i] - a->x[k], py = b->y[i] - a->y[k];
			double t = square > 0.0 ? fmin(fmax((px * ex + py * ey) / square, 0.0), 1.0) : 0.0;
			least = fmin(least, hypot(px - t * ex, py - t * ey));
		}
	return least;
}

double exact_distance(const Exact* a, const Exact* b)
{
	double axes = fmax(exact_axes(a, b), exact_axes(b, a)), radii = a->radius + b->radius;
	if (axes < 0.0 && !isinf(axes))
		return axes - radii;
	return fmin(exact_corners(a, b), exact_corners(b, a)) - radii;
}

// Along a line, the distance of two shapes is a convex function where it is positive, so ternary search finds its
// minimum.
double exact_meeting(const Exact* a, const Exact* b, double x, double y, double* least)
{
	double low = 0.0, high = 1.0;
	*least = exact_distance(a, b);
	if (*least <= 0.0)
		return 0.0;
	for (int k = 0; k < 80; ++k)
	{
		double first = low + (high - low) / 3.0, second = high - (high - low) / 3.0;
		Exact one = exact_moved(*b, first * x, first * y), two = exact_moved(*b, second * x, second * y);
		double d1 = exact_distance(a, &one), d2 = exact_distance(a, &two);
		if (d1 <= 0.0 || d1 <= d2)
			high = second;
		else
			low = first;
	}
	Exact there = exact_moved(*b, high * x, high * y);
	*least = exact_distance(a, &there);
	if (*least > 0.0)
		return 2.0;
	double before = 0.0, after = high;
	for (int k = 0; k < 60; ++k)
	{
		double middle = 0.5 * (before + after);
		there = exact_moved(*b, middle * x, middle * y);
		if (exact_distance(a, &there) > 0.0)
			before = middle;
		else
			after = middle;
	}
	return after;
}
