// SPDX-License-Identifier: MIT
// shape_difference.c -- computes the Minkowski difference of two shapes. Its hull is found by Andrew's monotone chain
// (Another efficient algorithm for convex hulls, 1979).
#include "shape_difference.h"
#include <math.h>
#include <stdlib.h>

typedef struct
{
	double x, y;
} Point;

static Point minus(Point a, Point b) { return (Point){a.x - b.x, a.y - b.y}; }
static double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
static double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

static int by_place(const void* a, const void* b)
{
	const Point *p = a, *q = b;
	return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y > q->y) - (p->y < q->y);
}

// Returns corner k of a turned shape. The rotation is divided by its length, which differs from 1 by rounding errors.
static Point corner(const scree_shape* shape, scree_rot turn, int k)
{
	double c = (double)turn.c, s = (double)turn.s, length = hypot(c, s);
	double x = (double)shape->vertices[k].x, y = (double)shape->vertices[k].y;
	return (Point){(c * x - s * y) / length, (s * x + c * y) / length};
}

// Adds the lower half of the hull of sorted points or, with step -1, the upper half. Returns the number of corners so
// far.
static int add_half(Difference* d, int count, const Point* points, int total, int step)
{
	int begin = count;
	for (int i = 0; i < total; ++i)
	{
		Point p = points[step > 0 ? i : total - 1 - i];
		while (count >= begin + 2)
		{
			Point before = {d->x[count - 2], d->y[count - 2]}, last = {d->x[count - 1], d->y[count - 1]};
			if (cross(minus(last, before), minus(p, before)) > 0.0)
				break;
			--count;
		}
		d->x[count] = p.x;
		d->y[count] = p.y;
		++count;
	}
	return count - 1; // the last point is also the first of the other half
}

Difference difference_of(const scree_shape* a, scree_pose at_a, const scree_shape* b, scree_pose at_b)
{
	Difference d = {.radius = (double)a->radius + (double)b->radius,
	                .at_x = (double)at_b.position.x - (double)at_a.position.x,
	                .at_y = (double)at_b.position.y - (double)at_a.position.y};
	Point points[MOST_DIFFERENCES];
	int total = 0;
	for (int i = 0; i < a->count; ++i)
		for (int j = 0; j < b->count; ++j)
			points[total++] = minus(corner(a, at_a.rotation, i), corner(b, at_b.rotation, j));
	qsort(points, (size_t)total, sizeof *points, by_place);
	int half = add_half(&d, 0, points, total, 1);
	d.count = add_half(&d, half, points, total, -1);
	d.count = d.count > 0 ? d.count : 1;
	return d;
}

static Point corner_of(const Difference* d, int k) { return (Point){d->x[k % d->count], d->y[k % d->count]}; }

double difference_distance(const Difference* d, double x, double y)
{
	Point q = {d->at_x + x, d->at_y + y};
	double near = INFINITY, depth = INFINITY;
	int inside = d->count > 2;
	for (int k = 0; k < d->count; ++k)
	{
		Point a = corner_of(d, k), edge = minus(corner_of(d, k + 1), a), from = minus(q, a);
		double square = dot(edge, edge), side = cross(edge, from);
		double share = square > 0.0 ? fmin(fmax(dot(from, edge) / square, 0.0), 1.0) : 0.0;
		near = fmin(near, hypot(from.x - share * edge.x, from.y - share * edge.y));
		inside = inside && side >= 0.0;
		depth = square > 0.0 ? fmin(depth, side / sqrt(square)) : depth;
	}
	return (inside ? -depth : near) - d->radius;
}

double difference_least(const Difference* d, double x, double y, double share)
{
	double low = 0.0, high = share; // ternary search, because the distance is a convex function of the share
	for (int k = 0; k < 100; ++k)
	{
		double first = low + (high - low) / 3.0, second = high - (high - low) / 3.0;
		if (difference_distance(d, first * x, first * y) <= difference_distance(d, second * x, second * y))
			high = second;
		else
			low = first;
	}
	return fmin(difference_distance(d, high * x, high * y),
	            fmin(difference_distance(d, 0.0, 0.0), difference_distance(d, share * x, share * y)));
}

typedef struct
{
	double share; // share of the path before the meeting; 2: no meeting
	Point normal; // outward normal of the surface at the meeting
} Entry;

static const Entry never = {2.0, {0.0, 0.0}};

// Returns the first meeting of a path with a circle around a corner; `never` if they do not meet. The path begins
// outside of the circle. `from`: start of the path relative to the center.
static Entry enter_circle(Point from, Point path, double radius)
{
	double square = dot(path, path), closing = -dot(from, path) / square;
	Point passing = {from.x + closing * path.x, from.y + closing * path.y};
	double room = radius * radius - dot(passing, passing);
	if (!(closing > 0.0) || room < 0.0 || radius == 0.0)
		return never;
	double share = closing - sqrt(room / square);
	Point at = {(from.x + share * path.x) / radius, (from.y + share * path.y) / radius};
	return share >= 0.0 && share <= 1.0 ? (Entry){share, at} : never;
}

// Returns the meeting of a path with an edge that is shifted outward by a radius; `never` if they do not meet. The
// outside is to the right of the edge. `from`: start of the path relative to the first corner of the edge.
static Entry enter_edge(Point from, Point path, Point edge, double radius)
{
	double length = sqrt(dot(edge, edge)), speed = cross(edge, path) / length, height = cross(edge, from) / length;
	if (!(speed > 0.0))
		return never;
	double share = (-radius - height) / speed;
	double along = (dot(from, edge) + share * dot(path, edge)) / (length * length);
	Point normal = {edge.y / length, -edge.x / length};
	return share >= 0.0 && share <= 1.0 && along >= 0.0 && along <= 1.0 ? (Entry){share, normal} : never;
}

double difference_meeting(const Difference* d, double x, double y, double* margin)
{
	Point path = {x, y};
	double begin = difference_distance(d, 0.0, 0.0), length = sqrt(dot(path, path));
	*margin = -begin;
	if (begin <= 0.0)
		return 0.0;
	Entry first = never;
	double left = -INFINITY, right = -INFINITY; // m: distances from the path to the outermost points left and right
	for (int k = 0; k < d->count && length > 0.0; ++k)
	{
		Point a = corner_of(d, k), edge = minus(corner_of(d, k + 1), a), from = {d->at_x - a.x, d->at_y - a.y};
		Entry circle = enter_circle(from, path, d->radius);
		Entry side = dot(edge, edge) > 0.0 ? enter_edge(from, path, edge, d->radius) : never;
		first = circle.share < first.share ? circle : first;
		first = side.share < first.share ? side : first;
		left = fmax(left, -cross(path, from) / length + d->radius);
		right = fmax(right, cross(path, from) / length + d->radius);
	}
	// m: distance of the end of the path behind the tangent of the surface at the meeting; 0 if there is no meeting
	double past = -(1.0 - first.share) * dot(first.normal, path);
	*margin = fmin(fmin(left, right), fmin(past, begin));
	return first.share;
}
