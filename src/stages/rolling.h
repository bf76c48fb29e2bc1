// SPDX-License-Identifier: MIT
// rolling.h -- normal, arms and gaps of a round contact, which follow the bodies.
//
// A point is at a corner of one core and on an edge, or at a corner, of the other: with the poses of the bodies that is all
// there is to know, and no place on a surface lags behind a roller.
//
// Forces of a step act along its normal while the bodies move on. Of a roller with a stiffness k of its geometry, which is
// load over mass and radius, a step of N substeps has the determinant 1 + ((N - 1) / (2 N) - s) k dt^2, if the normal is
// that of the share s of the step: at s = 0 it gains energy, at s = 1 it loses some. So the poses are those of the end of
// the step. Where k dt^2 is too large for that, as for a small body under a heap, the contact follows its share alone, and
// is held for the rest (contact_points.h).
#ifndef ROLLING_H
#define ROLLING_H
#include "stages/contact_points.h"
#include "stages/sweep_closing.h"

// k dt^2 that a contact may follow; bodies have several, and their neighbors have them too
#define ROLLING_STIFFNESS 0.3f

// A rolling body stops: the load acts so far before the center, in reaches, at most. That is a rolling resistance of a ten
// thousandth, a tenth of steel's on steel. Below this it is so much of the turn of a step.
#define ROLLING_LEVER 1.0e-4f
#define ROLLING_TURN  0.3f

// What is stiff is held in part, and found anew now and then, which would keep it swinging: there the lever may be longer.
#define ROLLING_STIFF_LEVER 0.05f

typedef struct // of a body until the end of the step, from the origin of collidable a
{
	Vec center, then; // center of mass, now and then, m
	Vec turn;         // cos, sin
	Vec axes;         // of its collidable, now
	Vec origin;       // of its collidable, now, m
} Rolling;

INLINE Rolling rolling_of(Vec origin, Placed placed, Advance advance)
{
	Rolling r;
	r.origin = origin;
	r.axes = vec(placed.c, placed.s);
	r.center = vec_add(origin, vec(placed.center_x, placed.center_y));
	r.then = vec_add(r.center, advance.path);
	r.turn = vec_rotation(advance.turn);
	return r;
}

// from the center of mass to a place of the collidable, then
INLINE Vec rolling_arm(Rolling r, Vec place)
{
	return vec_turn(r.turn, vec_add(vec_sub(r.origin, r.center), vec_turn(r.axes, place)));
}

// how far the place goes that the solver takes to be at an arm
INLINE Vec rolling_moves(Rolling r, Vec arm)
{
	return vec_add(vec_sub(r.then, r.center), contact_points_swing(r.turn, arm));
}

// A corner of a core by its name, which is more exact than where it was found. Not every feature is a corner.
INLINE Vec rolling_corner(const GLOBAL Attribute* shape, int name, Vec found)
{
	if (name >= MAX_CORNERS)
		return found;
	Float2 v = shape->vertices[name];
	return vec(v.x, v.y);
}

// flags of the contact
INLINE ContactPoints rolling_points(Placed a, Placed b, Found found, Word flags, Int2 feature,
                                    const GLOBAL Attribute* shape_a, const GLOBAL Attribute* shape_b, Advance advance_a,
                                    Advance advance_b)
{
	Rolling ra = rolling_of(vec(0.0f, 0.0f), a, advance_a), rb = rolling_of(vec(b.x - a.x, b.y - a.y), b, advance_b);
	Vec shift = vec(found.relative.x, found.relative.y), turn = vec(found.relative.z, found.relative.w);
	Vec normal = vec(found.normal.x, found.normal.y), place[2];
	float separation[2] = {found.normal.z, found.normal.w};
	place[0] = vec(found.on_a.x, found.on_a.y);
	place[1] = vec(found.on_a.z, found.on_a.w);
	ContactPoints points;
	points.normal = vec_turn(ra.turn, vec_turn(ra.axes, normal));
	if (flags & FOUND_TURNS_B)
		points.normal = vec_turn(rb.turn, vec_turn(rb.axes, vec_turn_back(turn, normal)));
	points.offset = vec_sub(ra.then, rb.then);
	for (int k = 0; k < 2; ++k)
	{
		int names = k ? feature.y : feature.x, corner_a = (flags & (k ? FOUND_CORNER2 : FOUND_CORNER1)) != 0;
		float above = 0.5f * separation[k]; // the surface, m
		Vec core_a = vec_sub(place[k], vec_scale(shape_a->radius + above, normal));
		Vec core_b = vec_turn_back(turn, vec_sub(vec_add(place[k], vec_scale(shape_b->radius + above, normal)), shift));
		if (corner_a || (flags & FOUND_CORNERS))
			core_a = rolling_corner(shape_a, names >> 8 & 255, core_a);
		if (!corner_a)
			core_b = rolling_corner(shape_b, names & 255, core_b);
		Vec arm_a = rolling_arm(ra, core_a), arm_b = rolling_arm(rb, core_b);
		Vec between = vec_sub(vec_sub(arm_b, arm_a), points.offset);
		if ((flags & FOUND_CORNERS) && k == 0)
		{
			// corners that have come to the same place have no direction
			Vec direction = vec_scale(1.0f / root(vec_dot(between, between)), between);
			if (vec_dot(direction, points.normal) > 0.5f)
				points.normal = direction;
		}
		float gap = vec_dot(points.normal, between) - shape_a->radius - shape_b->radius;

		// from the center of the body that has the corner: the other may be large, and its center far away
		if (corner_a || (flags & FOUND_CORNERS))
			arm_a = vec_add(arm_a, vec_scale(shape_a->radius + 0.5f * gap, points.normal));
		else
			arm_a = vec_sub(vec_sub(arm_b, vec_scale(shape_b->radius + 0.5f * gap, points.normal)), points.offset);
		if (separation[k] == NO_POINT)
		{
			gap = NO_POINT;
			arm_a = points.anchor[0];
		}
		points.anchor[k] = arm_a;
		points.point[k] = vec_add(ra.then, arm_a);
		Vec parts = vec_sub(rolling_moves(rb, vec_add(arm_a, points.offset)), rolling_moves(ra, arm_a));
		points.separation[k] = gap - vec_dot(points.normal, parts);
	}
	return points;
}

// the same contact as if it were held
INLINE ContactPoints rolling_held(Placed a, Placed b, Found found)
{
	float row_a[8] = {a.x, a.y, a.c, a.s, a.center_x, a.center_y, 0.0f, 0.0f};
	float row_b[8] = {b.x, b.y, b.c, b.s, b.center_x, b.center_y, 0.0f, 0.0f};
	float rows[16] = {found.normal.x,   found.normal.y,   found.normal.z,   found.normal.w,
	                  found.on_a.x,     found.on_a.y,     found.on_a.z,     found.on_a.w,
	                  found.relative.x, found.relative.y, found.relative.z, found.relative.w,
	                  found.then.x,     found.then.y,     found.then.z,     found.then.w};
	return contact_points_held(row_a, row_b, rows);
}

INLINE Vec rolling_between(Vec a, Vec b, float share) { return vec_add(a, vec_scale(share, vec_sub(b, a))); }

// The points of a contact for the step; load1 and load2 are its normal impulses of a substep, N s.
INLINE ContactPoints rolling_step(const Pools* p, Placed a, Placed b, Found found, Word flags, Int2 feature,
                                  float load1, float load2, Advance advance_a, Advance advance_b)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	ContactPoints points = rolling_points(a, b, found, flags, feature, shape_a, shape_b, advance_a, advance_b);
	float load = load1 + load2;
	if (!(load > 0.0f))
		return points;

	// what rests on two points does not roll; with both as loaded, what is round buckles like what is sharp
	float share = absolute(load1 - load2) / load;
	BodyState body_a = p->body[a.body], body_b = p->body[b.body];
	float reach = minimum(shape_a->reach, shape_b->reach);
	float mobility = body_a.inv_mass + body_b.inv_mass + reach * reach * (body_a.inv_inertia + body_b.inv_inertia);
	float stiffness = p->step.dt * p->step.dt * p->step.inv_h * load * mobility / reach;
	if (stiffness > ROLLING_STIFFNESS)
		share = share * (ROLLING_STIFFNESS / stiffness);

	// a lever against the relative turn, along the tangent; where the contact is stiff less, or it would turn it back
	float turn = (advance_b.turn - advance_a.turn) * (stiffness > 1.0f ? ROLLING_TURN / stiffness : ROLLING_TURN);
	float most = ROLLING_LEVER;
	if (stiffness > ROLLING_STIFFNESS)
		most += ROLLING_STIFF_LEVER * (1.0f - ROLLING_STIFFNESS / stiffness);
	float lever = -reach * minimum(maximum(turn, -most), most);
	Vec along = vec_scale(lever, vec(points.normal.y, -points.normal.x));
	ContactPoints held = rolling_held(a, b, found);
	points.normal = rolling_between(held.normal, points.normal, share);
	points.offset = rolling_between(held.offset, points.offset, share);
	for (int k = 0; k < 2; ++k)
	{
		points.anchor[k] = vec_add(rolling_between(held.anchor[k], points.anchor[k], share), along);
		points.separation[k] = held.separation[k] + share * (points.separation[k] - held.separation[k]);
	}
	return points;
}

#endif
