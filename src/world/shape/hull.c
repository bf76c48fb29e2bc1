// SPDX-License-Identifier: MIT
// hull.c -- computes the convex hull of a few points.
// This work is based on: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996, in two dimensions.
#include "world/shape/hull.h"
#include "world/shape/geometry.h"
#include <math.h>

typedef struct
{
	const scree_vec* points;
	int* corners;
	int count;
	Tolerance tolerance;
} Hull;

// Appends the hull's corners between corners a and b, in order. outside: points to the right of the line from a to b.
static void add_side(Hull* hull, int a, int b, const int* outside, int outside_count)
{
	const scree_vec* p = hull->points;
	double length = vec_distance(p[a], p[b]), farthest = hull->tolerance.flat;
	int corner = -1;
	for (int k = 0; k < outside_count; ++k)
	{
		double distance = -vec_cross_from(p[a], p[b], p[outside[k]]) / length;
		if (distance > farthest)
		{
			farthest = distance;
			corner = outside[k];
		}
	}
	if (corner < 0)
		return;

	// points to the right of the line from a to `corner`, and points to the right of the line from `corner` to b
	int first[HULL_POINTS], second[HULL_POINTS], first_count = 0, second_count = 0;
	for (int k = 0; k < outside_count; ++k)
	{
		int i = outside[k];
		if (i != corner && vec_cross_from(p[a], p[corner], p[i]) < 0.0)
			first[first_count++] = i;
		else if (i != corner && vec_cross_from(p[corner], p[b], p[i]) < 0.0)
			second[second_count++] = i;
	}
	add_side(hull, a, corner, first, first_count);
	hull->corners[hull->count++] = corner;
	add_side(hull, corner, b, second, second_count);
}

// Removes flat corners one by one, the flattest first, because each removal makes the neighboring corners less flat.
static void drop_flat(Hull* hull)
{
	while (hull->count >= 3)
	{
		int flattest = -1;
		double least = hull->tolerance.flat;
		for (int k = 0; k < hull->count; ++k)
		{
			scree_vec before = hull->points[hull->corners[(k + hull->count - 1) % hull->count]];
			scree_vec here = hull->points[hull->corners[k]];
			scree_vec after = hull->points[hull->corners[(k + 1) % hull->count]];
			double height = vec_cross_from(before, here, after) / vec_distance(before, after);
			if (height < least)
			{
				least = height;
				flattest = k;
			}
		}
		if (flattest < 0)
			return;
		--hull->count;
		for (int k = flattest; k < hull->count; ++k)
			hull->corners[k] = hull->corners[k + 1];
	}
}

int hull_corners(const scree_vec* points, int count, int* corners)
{
	Tolerance tolerance = tolerance_of(points, count);

	// welding: of several close points, only the first is kept
	int kept[HULL_POINTS], kept_count = 0;
	for (int i = 0; i < count; ++i)
	{
		int k = 0;
		while (k < kept_count && vec_distance(points[i], points[kept[k]]) >= tolerance.weld)
			++k;
		if (k == kept_count)
			kept[kept_count++] = i;
	}
	if (kept_count < 3)
		return kept_count;

	// the lowest of the leftmost points is a corner, and so is the highest of the rightmost points
	int left = kept[0], right = kept[0];
	for (int k = 1; k < kept_count; ++k)
	{
		scree_vec p = points[kept[k]], l = points[left], r = points[right];
		if (p.x < l.x || (p.x == l.x && p.y < l.y))
			left = kept[k];
		if (p.x > r.x || (p.x == r.x && p.y > r.y))
			right = kept[k];
	}

	int below[HULL_POINTS], above[HULL_POINTS], below_count = 0, above_count = 0;
	for (int k = 0; k < kept_count; ++k)
	{
		double side = vec_cross_from(points[left], points[right], points[kept[k]]);
		if (side < 0.0)
			below[below_count++] = kept[k];
		else if (side > 0.0)
			above[above_count++] = kept[k];
	}
	Hull hull = {points, corners, 0, tolerance};
	corners[hull.count++] = left;
	add_side(&hull, left, right, below, below_count);
	corners[hull.count++] = right;
	add_side(&hull, right, left, above, above_count);
	drop_flat(&hull);
	return hull.count;
}
