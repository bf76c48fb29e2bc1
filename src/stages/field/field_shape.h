// SPDX-License-Identifier: MIT
// field_shape.h -- computes forces of fields on shapes: wind on the outline, buoyancy on the immersed part.
//
// This work is based on:
// Archimedes, On Floating Bodies: the force of a fluid is the weight of the displaced fluid, and acts at its centroid.
// Ludwig Prandtl, Oskar Tietjens, Fundamentals of Hydro- and Aeromechanics, 1934: drag and lift by the square of speed.
#ifndef FIELD_SHAPE_H
#define FIELD_SHAPE_H
#include "stages/field/field_area.h"
#include "stages/field/field_sum.h"

typedef struct // shape on which fields act
{
	const GLOBAL Attribute* shape;
	Vec at, turn, arm; // position of the shape, m; rotation; vector from the body's center of mass to this position, m
	Vec v;             // m/s: velocity of the body's center of mass
	float w;
} FieldTarget;

// Returns the velocity of the medium relative to a point. arm, m: vector from the body's center of mass to the point.
INLINE Vec field_passing(const GLOBAL Field* field, const FieldSample* spot, const FieldTarget* t, Vec arm)
{
	Vec at = vec_add(t->at, vec_sub(arm, t->arm));
	return vec_sub(field_flow(field, spot, at), vec_add(t->v, vec_spin(t->w, arm)));
}

INLINE Vec field_middle(const GLOBAL Attribute* shape)
{
	Vec sum = vec(0.0f, 0.0f);
	for (int k = 0; k < shape->count; ++k)
		sum = vec_add(sum, vec(shape->vertices[k].x, shape->vertices[k].y));
	return vec_scale(quotient(1.0f, (float)shape->count), sum);
}

// Adds drag and lift of the wind, if the mean of the corners is in the field. They act at the middle of each edge that
// faces the wind, in proportion to the edge's width across the wind. A rounded shape is wider than its core by twice
// its radius; the drag of this width acts at the mean of the corners.
INLINE void field_blow(const GLOBAL Field* field, const FieldSample* spot, const FieldTarget* t, FieldForce* sum)
{
	const GLOBAL Attribute* shape = t->shape;
	float pressure = 0.5f * field->density;
	Vec middle = vec_add(t->arm, vec_turn(t->turn, field_middle(shape)));
	if (!field_holds(field, spot, vec_add(t->at, vec_sub(middle, t->arm))))
		return;
	for (int k = 0; k < shape->count && shape->count > 1; ++k)
	{
		Float2 a = shape->vertices[k], b = shape->vertices[k + 1 < shape->count ? k + 1 : 0];
		Vec normal = vec_turn(t->turn, vec(shape->normals[k].x, shape->normals[k].y));
		Vec edge = vec(b.x - a.x, b.y - a.y), own = vec(0.5f * (a.x + b.x), 0.5f * (a.y + b.y));
		Vec arm = vec_add(vec_add(t->arm, vec_turn(t->turn, own)), vec_scale(shape->radius, normal));
		Vec e = field_passing(field, spot, t, arm);
		float speed = square_root(vec_dot(e, e)), facing = -vec_dot(normal, e);
		if (!(facing >= TINY && speed >= TINY)) // `speed` may be 0: squares of small numbers may be rounded to 0
			continue;
		float rate = pressure * facing * square_root(vec_dot(edge, edge));
		float side = field->lift * rate * quotient(vec_cross(normal, e), speed);
		field_brake(sum, arm, field->drag * rate, vec_scale(field->drag * rate, e));
		field_brake(sum, arm, absolute(side), vec_spin(side, e));
	}
	if (shape->radius > 0.0f)
	{
		Vec e = field_passing(field, spot, t, middle);
		float rate = pressure * field->drag * (2.0f * shape->radius) * square_root(vec_dot(e, e));
		field_brake(sum, middle, rate, vec_scale(rate, e));
	}
}

// Returns edge k of a field's region. A field without a shape has one edge: the surface of a fluid without a bottom.
INLINE FieldEdge field_edge(const GLOBAL Field* field, const FieldSample* spot, int k, const FieldTarget* t)
{
	FieldEdge edge;
	Vec normal = vec(0.0f, 1.0f), at = vec(0.0f, 0.0f), turn = vec(spot->pose.z, spot->pose.w);
	if (field->shape.count > 0)
	{
		normal = vec(field->shape.normals[k].x, field->shape.normals[k].y);
		at = vec(field->shape.vertices[k].x, field->shape.vertices[k].y);
	}
	at = vec_turn(turn, at);
	edge.normal = vec_turn(turn, normal);
	edge.offset = vec_dot(edge.normal, vec((t->at.x - spot->pose.x) - at.x, (t->at.y - spot->pose.y) - at.y));
	return edge;
}

// m: Returns the largest height of a shape's points above an edge; if `sign` is -1, the largest depth below the edge.
INLINE float field_height(const FieldTarget* t, FieldEdge edge, float sign)
{
	Vec normal = vec_turn_back(t->turn, vec_scale(sign, edge.normal));
	float most = -MOST_FLOAT;
	for (int k = 0; k < t->shape->count; ++k)
		most = maximum(most, vec_dot(normal, vec(t->shape->vertices[k].x, t->shape->vertices[k].y)));
	return sign * edge.offset + most + t->shape->radius;
}

// Returns the area and the moments of a shape's immersed part; 0 if no part is immersed. *depth, m: length of the
// shortest translation that takes the whole shape out of the fluid; not positive if the shape is outside.
INLINE FieldArea field_immersed(const GLOBAL Field* field, const FieldSample* spot, const FieldTarget* t, float* depth)
{
	FieldArea none = {0.0f, 0.0f, 0.0f};
	*depth = MOST_FLOAT;
	FieldEdge edges[MAX_CORNERS], line;
	int cuts = 0, count = field->shape.count > 0 ? field->shape.count : 1;
	line.normal = vec(0.0f, 1.0f);
	line.offset = 0.0f;
	line.offset = -field_height(t, line, 1.0f);
	for (int k = 0; k < count; ++k)
	{
		FieldEdge edge = field_edge(field, spot, k, t);
		edges[k] = edge;
		*depth = minimum(*depth, field_height(t, edge, -1.0f));
		if (!(*depth > 0.0f))
			return none;
		if (!(field_height(t, edge, 1.0f) > 0.0f))
			continue;
		cuts |= 1 << k;
		line = edge;
	}
	if (cuts & (cuts - 1))
		return field_area_clipped(t->shape, t->turn, edges, cuts);
	return field_area_below(t->shape, t->turn, line);
}

// N: Returns the maximum force of a fluid at a point; otherwise a very light body would be thrown out. The force may
// balance gravity and, in addition, change the speed in a step by the smaller of depth / dt, so that the shape just
// leaves the fluid, and 2 sqrt(g width), as for a ball released under water. Bodies can carry dozens of times their
// weight.
INLINE float field_most_lift(const Pools* p, int body, Vec arm, Vec gravity, float weight, float depth, float width)
{
	BodyState state = p->body[body];
	float dt = p->step.dt, lever = quotient(vec_cross(arm, gravity), weight);
	float easy = state.inv_mass + lever * lever * state.inv_inertia;
	float most = minimum(quotient(depth, dt * dt), quotient(2.0f * square_root(weight * width), dt));
	return quotient(weight + most, easy);
}

// Adds the forces of a fluid. Three of them act at the centroid of the immersed part: buoyancy, drag in proportion to
// the immersed area, and drag in proportion to v^2, as for a disc of the same area. The drag of rotation is a torque.
INLINE void field_float(const Pools* p, const GLOBAL Field* field, const FieldSample* spot, int body,
                        const FieldTarget* t, FieldForce* sum)
{
	if (t->shape->count < 3 && !(t->shape->radius > 0.0f))
		return;
	float depth;
	FieldArea part = field_immersed(field, spot, t, &depth);
	if (!(part.area > 0.0f))
		return;
	Vec arm = vec_add(t->arm, vec(quotient(part.x, part.area), quotient(part.y, part.area)));
	Vec gravity = vec(gravity_x_of(p, body), gravity_y_of(p, body));
	float weight = square_root(vec_dot(gravity, gravity)), width = 2.0f * square_root(part.area * 0.318309886f);
	if (weight > 0.0f && weight < MOST_FLOAT)
	{
		float most = field_most_lift(p, body, arm, gravity, weight, depth, width);
		field_push(sum, arm, vec_scale(-minimum(field->density * part.area, quotient(most, weight)), gravity));
	}
	Vec e = field_passing(field, spot, t, arm);
	float rate =
	    field->linear_drag * part.area + 0.5f * field->density * field->drag * width * square_root(vec_dot(e, e));
	field_brake(sum, arm, rate, vec_scale(rate, e));

	// drag of rotation, as of a rod; its half length is at most the distance from the middle to the farthest point
	Vec middle = field_middle(t->shape);
	float most = 0.0f;
	for (int k = 0; k < t->shape->count; ++k)
	{
		Vec way = vec_sub(vec(t->shape->vertices[k].x, t->shape->vertices[k].y), middle);
		most = maximum(most, vec_dot(way, way));
	}
	float square = (most + t->shape->radius * t->shape->radius) * (1.0f / 3.0f);
	field_brake_spin(sum, field->linear_drag * part.area * square, spot->w - t->w);
}

// own: index of the body within its bay.
INLINE void field_act_shape(const Pools* p, int collidable, int body, int own, const GLOBAL Field* field,
                            const GLOBAL FieldSample* sample, const FieldTarget* t, FieldForce* sum)
{
	if (field->kind < FIELD_WIND || field->body == own || (!field->all && !field_sees(field, p->filter + collidable)))
		return;
	FieldSample spot = *sample;
	if (field->kind == FIELD_WIND)
		field_blow(field, &spot, t, sum);
	else
		field_float(p, field, &spot, body, t, sum);
}

// Item: a collidable. Sums the forces of fields on its shape. argument: number of fields, without the padding; in a batch, of
// spots of a bay.
KERNEL(field_shape)
{
	// the run may have the bound of an early solve
	if (p->step.sleep && i >= p->counters->active_items[GROUPS_OF_COLLIDABLES])
		return;
	i = active_item(p, GROUPS_OF_COLLIDABLES, i);
	if (p->collidable_kind[i] != KIND_DYNAMIC)
		return;
	int body = p->collidable_body[i];
	FieldTarget t;
	t.shape = p->attribute + p->collidable_attribute[i];
	Float4 pose = field_body_point(p, body, p->collidable_pose[i], &t.arm);
	t.at = vec(pose.x, pose.y);
	t.turn = vec(pose.z, pose.w);
	t.v = vec(p->body[body].vx, p->body[body].vy);
	t.w = p->body[body].w;
	float reach = t.shape->reach;
	Float4 box = make_float4(pose.x - reach, pose.y - reach, pose.x + reach, pose.y + reach);
	FieldForce sum = field_nothing();
	int bay = bay_of_body(p, body), own = body - bay * p->step.bays.bodies;
	FieldTraversal traversal = field_traverse(p, bay, p->argument, box);
	for (int spot = field_next(p, &traversal); spot >= 0; spot = field_next(p, &traversal))
		field_act_shape(p, i, body, own, p->field + (spot + traversal.fields), p->field_sample + spot, &t, &sum);
	p->field_force[i] = sum;
}

#endif
