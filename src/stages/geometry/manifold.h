// SPDX-License-Identifier: MIT
// manifold.h -- computes the manifold of two convex shapes: a normal and at most two points.
//
// A shape consists of all points within a radius of its core, the convex hull of its vertices; a core of two vertices
// has two edges, back to back. The reference edge is the edge along whose normal the cores are farthest apart. The
// edge of the other core that faces it most, the incident edge, is clipped to its length (I. Sutherland and G. Hodgman,
// Reentrant Polygon Clipping, 1974); the ends give two points. If a corner faces a corner, the manifold has one point,
// between the nearest points of both shapes.
#ifndef MANIFOLD_H
#define MANIFOLD_H
#include "stages/geometry/manifold_axis.h"
#include "stages/geometry/manifold_nearest.h"

// m: if the best edges of two shapes face each other, that of shape a is the reference edge only if its separation is
// larger than that of the edge of shape b by at least this, so that the choice does not alternate from step to step.
// Shape b is preferred, because it does not move or is the larger one. If the edges do not face each other, the one
// with the larger separation is used, because the other may not be at the nearest points.
#define REFERENCE_BIAS (0.1f * LINEAR_SLOP)
// m: tolerance. Two edges make the manifold if the nearer clipped point is at most this much farther from the reference
// edge than the separation of the cores. A distance up to this gives no direction.
#define NEAREST_TOLERANCE (0.01f * LINEAR_SLOP)
// m: two circles whose centers are at most this far apart get the y axis as their normal. The limit is small, so that
// the normals of all other bodies near one place fit their positions.
#define CENTERS_APART (0.0002f * LINEAR_SLOP)

typedef struct // manifold in the frame of shape a
{
	Vec normal;         // unit vector from shape a to shape b
	Vec point[2];       // points in the middle between the two surfaces, m
	Real separation[2]; // separation of the surfaces, negative if they overlap, m; NO_POINT for a missing point
	int feature[2];     // feature of shape a << 8 | feature of shape b; different for the two points
	int count;          // number of points; if it is 0, the normal may be 0 too
	int made;           // MANIFOLD_* bits: shapes whose corners are points; shape with which the normal rotates
	Real gap;           // lower bound of the distance of the surfaces, m, if there are no points
} Manifold;

typedef struct // maximum separation of contact points, which depends on the normal (reach_along)
{
	Real within; // m: maximum separation if the shapes do not approach each other
	Vec near;    // m: displacement of shape b, in the frame of shape a, in the rest of the step
	Real swing;  // m: upper bound of the additional displacement of a point of shape b
} Reach;

INLINE Reach reach_of(Real within)
{
	Reach r;
	r.within = within;
	r.near = vec(0.0f, 0.0f);
	r.swing = 0.0f;
	return r;
}

// Returns the maximum separation of contact points along a normal from shape a to shape b: r.within, plus the largest
// possible approach in the rest of the step.
INLINE Real reach_along(Reach r, Vec normal) { return r.within + maximum(r.swing - vec_dot(normal, r.near), 0.0f); }

INLINE Manifold no_manifold(void)
{
	Manifold m;
	m.normal = m.point[0] = m.point[1] = vec(0.0f, 0.0f);
	m.separation[0] = m.separation[1] = NO_POINT;
	m.feature[0] = m.feature[1] = 0;
	m.count = 0;
	m.made = 0;
	m.gap = 0.0f;
	return m;
}

// Adds the point in the middle between the two surfaces, unless their separation is larger than `within`, m. `from`:
// point of the core of shape a; height, m: distance from this point to the core of shape b along the normal.
INLINE void manifold_add(Manifold* m, Vec from, Real height, Real radius_a, Real radius_b, int feature, Real within)
{
	Real separation = flush_tiny(height - radius_a - radius_b);
	if (!(separation <= within))
		return;
	Vec point = vec_add(from, vec_scale(0.5f * (height + radius_a - radius_b), m->normal));

	// constant indices keep the manifold in registers
	if (m->count == 0)
	{
		m->point[0] = point;
		m->separation[0] = separation;
		m->feature[0] = feature;
	}
	else
	{
		m->point[1] = point;
		m->separation[1] = separation;
		m->feature[1] = feature;
	}
	m->count += 1;
}

INLINE Manifold circles_manifold(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Frame f, Reach reach)
{
	Manifold m = no_manifold();
	Vec from = shape_corner(a, 0);
	Vec delta = vec_sub(frame_point(f, shape_corner(b, 0)), from);
	Real distance = root(vec_dot(delta, delta));
	m.normal = distance > CENTERS_APART ? vec_scale(quotient(1.0f, distance), delta) : vec(0.0f, 1.0f);
	m.made = MANIFOLD_CORNERS;
	m.gap = distance - a->radius - b->radius;
	manifold_add(&m, from, distance, a->radius, b->radius, 0, reach_along(reach, m.normal));
	return m;
}

INLINE int feature_pair(int a, int b) { return a << 8 | b; }

typedef struct // reference edge of shape a, from the corner with index `edge` to that with index `next`
{
	Vec origin, right, up; // first corner; unit vectors along the edge and along its normal
	Real length;           // m
	int edge, next;
} Reference;

INLINE Reference reference_of(const GLOBAL Attribute* a, int i)
{
	Reference r;
	r.edge = i;
	r.next = shape_next(a, i);
	r.origin = shape_corner(a, i);
	r.up = shape_normal(a, i);
	r.right = vec(-r.up.y, r.up.x);
	r.length = vec_dot(vec_sub(shape_corner(a, r.next), r.origin), r.right);
	return r;
}

// Returns the incident edge: of the two edges at shape b's deepest corner, the one that faces the reference edge more.
// It leads against the direction of the reference edge. *facing: product of both normals, -1 for parallel edges.
INLINE Edge incident_edge(const GLOBAL Attribute* b, int corner, const Reference* r, Frame f, Real* facing)
{
	int j = corner, before = j > 0 ? j - 1 : b->count - 1;
	Vec turned = vec_turn_back(f.rotation, r->up);
	*facing = vec_dot(turned, shape_normal(b, j));
	Real facing_before = vec_dot(turned, shape_normal(b, before));
	if (facing_before < *facing)
	{
		*facing = facing_before;
		j = before;
	}
	int j2 = shape_next(b, j);
	Vec start = vec_sub(frame_point(f, shape_corner(b, j)), r->origin);
	Vec end = vec_sub(frame_point(f, shape_corner(b, j2)), r->origin);
	Edge incident;
	incident.start = vec(vec_dot(start, r->right), vec_dot(start, r->up));
	incident.end = vec(vec_dot(end, r->right), vec_dot(end, r->up));
	incident.start_feature = j;
	incident.end_feature = j2;
	incident.feature = FEATURE_EDGE + j;
	return incident;
}

// Returns a manifold of at most one point, in the middle between the surfaces, at the nearest points of both edges.
INLINE Manifold nearest_manifold(const GLOBAL Attribute* a, const GLOBAL Attribute* b, const Reference* r,
                                 Edge incident, Real separation, Reach reach)
{
	Edge reference;
	reference.start = vec(0.0f, 0.0f);
	reference.end = vec(r->length, 0.0f);
	reference.start_feature = r->edge;
	reference.end_feature = r->next;
	reference.feature = FEATURE_EDGE + r->edge;
	Nearest n = nearest_points(reference, incident);
	Real distance = root(n.square);

	// two thin cores on one line may be apart although no normal of their edges separates them
	int thin = a->count < 3 && b->count < 3;
	int apart = separation > 0.0f || (thin && distance + separation > NEAREST_TOLERANCE);
	Manifold m = no_manifold();
	m.normal = r->up;
	Vec from = vec(n.to.x, 0.0f);
	Real height = n.to.y;
	if (apart && distance > NEAREST_TOLERANCE)
	{
		Vec delta = vec_scale(quotient(1.0f, distance), vec_sub(n.to, n.from));
		m.normal = vec_add(vec_scale(delta.x, r->right), vec_scale(delta.y, r->up));
		from = n.from;
		height = distance;
		int corner_a = n.from_feature < FEATURE_EDGE, corner_b = n.to_feature < FEATURE_EDGE;
		m.made = corner_a && corner_b ? MANIFOLD_CORNERS : corner_a ? MANIFOLD_CORNER1 | MANIFOLD_TURNS_B : 0;
	}
	from = vec_add(r->origin, vec_add(vec_scale(from.x, r->right), vec_scale(from.y, r->up)));
	manifold_add(&m, from, height, a->radius, b->radius, feature_pair(n.from_feature, n.to_feature),
	             reach_along(reach, m.normal));
	return m;
}

// Returns the manifold of two shapes. axis: reference edge, in shape a. separation, m: largest along any edge's normal.
INLINE Manifold edge_manifold(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Axis axis, Real separation, Frame f,
                              Reach reach)
{
	Reference r = reference_of(a, axis.edge);
	Real facing;
	Edge incident = incident_edge(b, axis.corner, &r, f, &facing);

	// clips the incident edge to the length of the reference edge
	Vec high = incident.start, low = incident.end;
	int overlap = high.x >= 0.0f && low.x <= r.length;
	int cut_high = overlap && high.x > r.length, cut_low = overlap && low.x < 0.0f;
	Vec along = vec_sub(low, high);
	if (cut_high)
		high = vec(r.length, high.y + quotient(high.x - r.length, -along.x) * along.y);
	if (cut_low)
		low = vec(0.0f, low.y + quotient(low.x, along.x) * -along.y);

	// no clipped point is nearer to the edge than `separation`; if both are farther, a corner faces a corner
	if (!overlap || minimum(high.y, low.y) > separation + NEAREST_TOLERANCE)
		return nearest_manifold(a, b, &r, incident, separation, reach);

	Manifold m = no_manifold();
	m.normal = r.up;
	int steep = facing > -FACING, i = r.edge, j = incident.start_feature;
	Real within = reach_along(reach, m.normal);
	m.made = cut_high ? MANIFOLD_CORNER1 : 0;
	manifold_add(&m, vec_add(r.origin, vec_scale(high.x, r.right)), high.y, a->radius, b->radius,
	             feature_pair(steep && !cut_high ? FEATURE_EDGE + i : r.next, steep && cut_high ? FEATURE_EDGE + j : j),
	             within);
	if (m.count == 0)
		m.made = 0;
	if (cut_low)
		m.made |= m.count == 0 ? MANIFOLD_CORNER1 : MANIFOLD_CORNER2;
	if (b->count > 1)
		manifold_add(&m, vec_add(r.origin, vec_scale(low.x, r.right)), low.y, a->radius, b->radius,
		             feature_pair(steep && !cut_low ? FEATURE_EDGE + i : i,
		                          steep && cut_low ? FEATURE_EDGE + j : incident.end_feature),
		             within);
	return m;
}

// Returns the same manifold with the two shapes exchanged. f: pose of the old frame in the new one.
INLINE Manifold manifold_swap(Manifold m, Frame f)
{
	m.normal = vec_neg(vec_turn(f.rotation, m.normal));
	if (!(m.made & MANIFOLD_CORNERS))
		m.made ^= MANIFOLD_TURNS_B | MANIFOLD_CORNER1 | MANIFOLD_CORNER2;
	for (int k = 0; k < 2; ++k)
	{
		if (k >= m.count)
			continue;
		m.point[k] = frame_point(f, m.point[k]);
		m.feature[k] = feature_pair(m.feature[k] & 255, m.feature[k] >> 8);
	}
	return m;
}

// Returns the manifold of two shapes in the frame of shape a, with points within `reach`. f: pose of b in this frame.
INLINE Manifold collide(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Frame f, Reach reach)
{
	if (a->count == 1 && b->count == 1)
		return circles_manifold(a, b, f, reach);

	Real radius = a->radius + b->radius;
	Axis on_a = best_axis(a, b, f);
	Manifold none = no_manifold();
	none.gap = on_a.separation - radius;
	if (none.gap > reach_along(reach, shape_normal(a, on_a.edge)))
		return none;
	Frame back = frame_inverse(f);
	Axis on_b = best_axis(b, a, back);
	Reach back_reach = reach;
	back_reach.near = vec_neg(vec_turn_back(f.rotation, reach.near));
	none.gap = maximum(none.gap, on_b.separation - radius);
	if (on_b.separation - radius > reach_along(back_reach, shape_normal(b, on_b.edge)))
		return none;

	Real separation = flush_tiny(maximum(on_a.separation, on_b.separation));
	Real facing = vec_dot(shape_normal(a, on_a.edge), vec_turn(f.rotation, shape_normal(b, on_b.edge)));
	Real bias = facing < -FACING ? REFERENCE_BIAS : 0.0f;
	int swap = on_b.separation + bias > on_a.separation;
	const GLOBAL Attribute* reference = a;
	const GLOBAL Attribute* incident = b;
	Frame frame = f;
	Axis axis = on_a;
	Reach facing_reach = reach;
	if (swap)
	{
		reference = b;
		incident = a;
		frame = back;
		axis = on_b;
		facing_reach = back_reach;
	}
	Manifold m = edge_manifold(reference, incident, axis, separation, frame, facing_reach);
	if (swap)
		m = manifold_swap(m, f);
	m.gap = none.gap;
	return m;
}

#endif
