// SPDX-License-Identifier: MIT
// field_area.h -- computes area and first moments of the part of a shape that is in a fluid.
//
// An outline consists of edges and arcs. The x axis lies on the surface of the fluid. The integrals of x dy, x^2 / 2 dy
// and x y dy around the immersed part are its area and its first moments. They are 0 along the surface of the fluid, so
// the sums over the immersed outline of the shape are exact. If several edges of a region cut a shape, corners
// replace the arcs of the shape, which is then clipped by one edge after the other.
//
// This work is based on:
// George Green, An Essay on the Application of Mathematical Analysis, 1828: areas from integrals along outlines.
// Ivan Sutherland, Gary Hodgman, Reentrant Polygon Clipping, 1974.
#ifndef FIELD_AREA_H
#define FIELD_AREA_H
#include "constraints/angle.h"
#include "pools/pools.h"

#define FIELD_CORNERS (3 * MAX_CORNERS + MAX_CORNERS) // corners of a clipped outline: 3 per arc, 1 more per cut

typedef struct // m^2, m^3: area and its first moments
{
	float area, x, y;
} FieldArea;

typedef struct // edge of a region; the distance of a point from it is negative in the fluid
{
	Vec normal;
	float offset; // m: distance of the shape's origin from the edge, negative in the fluid
} FieldEdge;

// Adds the integrals along an edge from point a to point b, without its part above y = 0.
INLINE void field_area_edge(FieldArea* sum, Vec a, Vec b)
{
	if (a.y > 0.0f && b.y > 0.0f)
		return;
	if (a.y > 0.0f || b.y > 0.0f)
	{
		Vec cut = vec(a.x + (b.x - a.x) * quotient(a.y, a.y - b.y), 0.0f);
		if (a.y > 0.0f)
			a = cut;
		else
			b = cut;
	}
	float rise = b.y - a.y;
	sum->area = sum->area + 0.5f * (a.x + b.x) * rise;
	sum->x = sum->x + (a.x * a.x + a.x * b.x + b.x * b.x) * (1.0f / 6.0f) * rise;
	sum->y = sum->y + (a.x * (2.0f * a.y + b.y) + b.x * (a.y + 2.0f * b.y)) * (1.0f / 6.0f) * rise;
}

// Adds the integrals along an arc of at most half a turn around a center, from direction a to direction b.
INLINE void field_area_piece(FieldArea* sum, Vec center, float r, Vec a, Vec b)
{
	float angle = vec_angle(vec_turn_back(a, b)), rise = b.y - a.y;
	angle = angle < -1.0f ? angle + 6.28318531f : angle; // half a turn may be computed as minus half a turn
	float squares = 0.5f * (angle + (b.x * b.y - a.x * a.y));
	float cubes = rise - (b.y * b.y * b.y - a.y * a.y * a.y) * (1.0f / 3.0f);
	float mixed = 0.5f * (b.y * b.y - a.y * a.y), mixed2 = (a.x * a.x * a.x - b.x * b.x * b.x) * (1.0f / 3.0f);
	float width = center.x * rise + r * squares;
	sum->area = sum->area + r * width;
	sum->x = sum->x + 0.5f * r * (center.x * center.x * rise + 2.0f * r * center.x * squares + r * r * cubes);
	sum->y = sum->y + r * (center.y * width + r * (center.x * mixed + r * mixed2));
}

// Adds the integrals along an arc, without its part above y = 0. Both ends may be below y = 0 and the middle above.
INLINE void field_area_arc(FieldArea* sum, Vec center, float r, Vec a, Vec b)
{
	float sine = quotient(-center.y, r); // sine of the directions in which the circle crosses the surface
	if (sine <= -1.0f)
		return;
	if (sine >= 1.0f)
	{
		field_area_piece(sum, center, r, a, b);
		return;
	}
	float cosine = square_root(1.0f - sine * sine);
	Vec enter = vec(-cosine, sine), leave = vec(cosine, sine);
	int below_a = a.y <= sine, below_b = b.y <= sine;
	if (below_a && below_b && !(a.x >= 0.0f && b.x <= 0.0f))
		field_area_piece(sum, center, r, a, b);
	else if (below_a || below_b)
	{
		if (below_a)
			field_area_piece(sum, center, r, a, leave);
		if (below_b)
			field_area_piece(sum, center, r, enter, b);
	}
	else if (a.x <= 0.0f && b.x >= 0.0f)
		field_area_piece(sum, center, r, enter, leave);
}

// Returns the area and the first moments of the part of a rotated shape that is below an edge. The moments are about
// the shape's origin, in world axes.
INLINE FieldArea field_area_below(const GLOBAL Attribute* shape, Vec turn, FieldEdge edge)
{
	FieldArea sum = {0.0f, 0.0f, 0.0f};
	float r = shape->radius;
	// rotation of the shape, relative to the x axis on the surface
	Vec axes = vec_turn_back(vec(edge.normal.y, -edge.normal.x), turn);
	int last = shape->count - 1;
	Vec before = vec_turn(axes, vec(shape->normals[last].x, shape->normals[last].y));
	for (int k = 0; k < shape->count; ++k)
	{
		Float2 a = shape->vertices[k], b = shape->vertices[k < last ? k + 1 : 0], own = shape->normals[k];
		Vec from = vec_turn(axes, vec(a.x, a.y)), to = vec_turn(axes, vec(b.x, b.y)),
		    normal = vec_turn(axes, vec(own.x, own.y));
		from.y = from.y + edge.offset;
		to.y = to.y + edge.offset;
		if (shape->count == 1)
		{
			field_area_arc(&sum, from, r, vec(1.0f, 0.0f), vec(-1.0f, 0.0f));
			field_area_arc(&sum, from, r, vec(-1.0f, 0.0f), vec(1.0f, 0.0f));
			continue;
		}
		if (r > 0.0f)
			field_area_arc(&sum, from, r, before, normal);
		field_area_edge(&sum, vec_add(from, vec_scale(r, normal)), vec_add(to, vec_scale(r, normal)));
		before = normal;
	}
	Vec moments = vec(sum.x, sum.y - sum.area * edge.offset);
	FieldArea part;
	part.area = sum.area;
	part.x = moments.x * edge.normal.y + moments.y * edge.normal.x;
	part.y = moments.y * edge.normal.y - moments.x * edge.normal.x;
	return part;
}

// Writes the corners of the outline of a rotated shape and returns their number. Corners that
// enclose the same area replace each arc: 8 for a circle, 5 for an end of a capsule, 3 for an arc of a polygon.
INLINE int field_outline(const GLOBAL Attribute* shape, Vec turn, Vec* out)
{
	int count = 0, last = shape->count - 1;
	Vec eighth = vec(0.707106781f, 0.707106781f);
	if (shape->count == 1)
	{
		Vec middle = vec_turn(turn, vec(shape->vertices[0].x, shape->vertices[0].y));
		Vec d = vec(1.05390736f * shape->radius, 0.0f);
		for (int k = 0; k < 8; ++k)
		{
			out[count++] = vec_add(middle, d);
			d = vec_turn(eighth, d);
		}
		return count;
	}
	Vec before = vec_turn(turn, vec(shape->normals[last].x, shape->normals[last].y));
	for (int k = 0; k < shape->count; ++k)
	{
		Vec at = vec_turn(turn, vec(shape->vertices[k].x, shape->vertices[k].y));
		Vec normal = vec_turn(turn, vec(shape->normals[k].x, shape->normals[k].y));
		if (shape->radius > 0.0f)
			out[count++] = vec_add(at, vec_scale(shape->radius, before));
		if (shape->radius > 0.0f && shape->count == 2)
		{
			// the arc is half a turn: three corners between its ends
			Vec d = vec_scale(1.07209f * shape->radius, before);
			for (int e = 0; e < 3; ++e)
			{
				d = vec_turn(eighth, d);
				out[count++] = vec_add(at, d);
			}
		}
		else if (shape->radius > 0.0f)
		{
			// the three corners enclose the area of an arc of angle `a` if the distance of the middle one is the radius
			// times (a / 2) / sin(a / 2), computed here as a series in sin^2(a / 2)
			Vec bisector = vec_add(before, normal);
			float square = vec_dot(bisector, bisector);        // square of twice the cosine of a / 2
			float less = maximum(1.0f - 0.25f * square, 0.0f); // square of the sine of a / 2
			float far = shape->radius * (1.0f + less * (1.0f / 6.0f) + less * less * (1.0f / 9.0f));
			out[count++] = vec_add(at, vec_scale(quotient(far, square_root(square)), bisector));
		}
		out[count++] = vec_add(at, vec_scale(shape->radius, normal));
		before = normal;
	}
	return count;
}

// Returns area and first moments of the part of a shape in the fluid. The edges whose bits in `cuts` are set bound the
// fluid. The moments are about the shape's origin, in world axes.
RARE FieldArea field_area_clipped(const GLOBAL Attribute* shape, Vec turn, const FieldEdge* edges, int cuts)
{
	Vec corners[FIELD_CORNERS], next[FIELD_CORNERS];
	int count = field_outline(shape, turn, corners);
	for (int e = 0; e < MAX_CORNERS; ++e)
	{
		if (!(cuts >> e & 1) || count == 0)
			continue;
		int kept = 0;
		Vec a = corners[count - 1];
		float depth_a = vec_dot(a, edges[e].normal) + edges[e].offset;
		for (int k = 0; k < count; ++k)
		{
			Vec b = corners[k];
			float depth_b = vec_dot(b, edges[e].normal) + edges[e].offset;
			int out_a = depth_a > 0.0f, out_b = depth_b > 0.0f;
			if (out_a != out_b && kept < FIELD_CORNERS)
				next[kept++] = vec_add(a, vec_scale(quotient(depth_a, depth_a - depth_b), vec_sub(b, a)));
			if (!out_b && kept < FIELD_CORNERS)
				next[kept++] = b;
			a = b;
			depth_a = depth_b;
		}
		for (int k = 0; k < kept; ++k)
			corners[k] = next[k];
		count = kept;
	}
	FieldArea sum = {0.0f, 0.0f, 0.0f};
	for (int k = 2; k < count; ++k)
	{
		Vec a = vec_sub(corners[k - 1], corners[0]), b = vec_sub(corners[k], corners[0]);
		float area = 0.5f * vec_cross(a, b);
		sum.area = sum.area + area;
		sum.x = sum.x + area * (1.0f / 3.0f) * (a.x + b.x);
		sum.y = sum.y + area * (1.0f / 3.0f) * (a.y + b.y);
	}
	if (count > 0)
	{
		sum.x = sum.x + sum.area * corners[0].x;
		sum.y = sum.y + sum.area * corners[0].y;
	}
	return sum;
}

#endif
