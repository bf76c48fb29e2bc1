// SPDX-License-Identifier: MIT
// field_forces.h -- computes the forces of fields on bodies, once per step, before the solve.
//
// A single item sums all forces on a body, so no two items write to one place. It first adds the forces on the body's
// collidables, in the order of their list, then the forces of fields that act on bodies, by rising index. So only the
// user's calls affect the sum. integrate applies it in each substep with the user's forces, and finalize clears it.
//
// This work is based on:
// Henry Crozier Plummer, On the Problem of Distribution in Globular Star Clusters, 1911: forces softened near a center.
#ifndef FIELD_FORCES_H
#define FIELD_FORCES_H
#include "stages/edit/command.h"
#include "stages/field/field_shape.h"

// Computes the pose and the box of a field. Item: its spot. argument: number of fields, in a batch of spots of a bay. The
// spots after the fields of a world get empty boxes.
KERNEL(field_place)
{
	Float4 box = box_empty();
	int bay = BATCHED(p) ? i / p->argument : 0, index = i - bay * p->argument, fields = p->argument;
	const GLOBAL Field* field = p->field + index;
	if (BATCHED(p))
	{
		field = field + p->bay[bay].field;
		fields = p->bay[bay].fields;
	}
	if (index < fields)
	{
		FieldSample spot = field_sample_of(p, field, field_carrier(p, field, bay));
		p->field_sample[i] = spot;
		if (field->shape.count == 0)
			box = make_float4(EMPTY_HIGH, EMPTY_HIGH, EMPTY_LOW, EMPTY_LOW); // contains every point
		for (int k = 0; k < field->shape.count; ++k)
		{
			Vec corner = field_turn(&spot, field->shape.vertices[k].x, field->shape.vertices[k].y);
			float x = spot.pose.x + corner.x, y = spot.pose.y + corner.y, r = field->shape.radius;
			box = box_union(box, make_float4(x - r, y - r, x + r, y + r));
		}
	}
	box_pack(p->field_box, i, box);
}

// Item: a group of ARITY boxes. Computes the box around them. argument: number of boxes, padding included.
KERNEL(field_gather)
{
	Float4 box = box_empty();
	for (int k = ARITY * i; k < ARITY * (i + 1) && k < p->argument; ++k)
		box = box_union(box, box_unpack(p->field_box, k));
	box_pack(p->field_group, i, box);
}

// 1/s^2: Returns the acceleration toward a center, divided by the distance from the center; negative if the field
// repels. way, m: vector to the center. The acceleration is limited so that a body at rest does not pass the center
// within a step; otherwise a strong field would eject bodies.
INLINE float field_pull(const Pools* p, const GLOBAL Field* field, Vec way)
{
	float r = square_root(vec_dot(way, way) + field->softening * field->softening), share = 1.0f;
	if (!(r >= TINY))
		return 0.0f;
	if (field->falloff == FALLOFF_LINEAR)
		share = maximum(1.0f - quotient(r, field->radius), 0.0f);
	else if (field->falloff != FALLOFF_CONSTANT)
		share = quotient(field->radius, r);
	if (field->falloff == FALLOFF_INVERSE_SQUARE)
		share = share * share;
	float most = quotient(1.0f, p->step.dt * p->step.dt);
	return within(quotient(field->strength * share, r), most);
}

// Returns whether the filter of a field accepts everything, or some dynamic collidable of a body.
INLINE int field_sees_body(const Pools* p, const GLOBAL Field* field, int body)
{
	if (field->all)
		return 1;
	for (int k = p->continuous_body[body].first; k > 0; k = p->next_collidable[k - 1])
		if (p->collidable_kind[k - 1] == KIND_DYNAMIC && field_sees(field, p->filter + k - 1))
			return 1;
	return 0;
}

// own: index of the body within its bay.
INLINE void field_act_body(const Pools* p, int body, int own, const GLOBAL Field* field,
                           const GLOBAL FieldSample* sample, Vec at, FieldForce* sum)
{
	if (field->kind >= FIELD_WIND || field->body == own)
		return;
	FieldSample spot = *sample;
	if (!field_holds(field, &spot, at) || !field_sees_body(p, field, body))
		return;
	BodyState state = p->body[body];
	float mass = quotient(1.0f, state.inv_mass);
	Vec center = vec(0.0f, 0.0f), way = vec(spot.pose.x - at.x, spot.pose.y - at.y);
	if (field->kind == FIELD_UNIFORM)
	{
		Vec a = field_turn(&spot, field->acceleration_x, field->acceleration_y);
		field_push(sum, center, vec_add(vec_scale(mass, a), field_turn(&spot, field->force_x, field->force_y)));
	}
	else if (field->kind == FIELD_DRAG)
	{
		Vec e = vec_sub(field_flow(field, &spot, at), vec(state.vx, state.vy));
		float spin = spot.w - state.w;
		float rate = field->linear_drag + field->quadratic_drag * square_root(vec_dot(e, e));
		field_brake(sum, center, rate, vec_scale(rate, e));
		field_brake_spin(sum, field->spin_drag + field->spin_drag_quadratic * absolute(spin), spin);
	}
	else
	{
		float pull = mass * field_pull(p, field, way);
		field_push(sum, center, field->kind == FIELD_RADIAL ? vec_scale(pull, way) : vec(pull * way.y, -pull * way.x));
	}
}

// Returns whether a body that carries fields moves, or was placed by the user since the last step.
INLINE int field_carried(const Pools* p, int carrier)
{
	float still = body_still(p, carrier);
	return body_is_moving(p, carrier) || still == STILL_MOVED ||
	       (still == STILL_STIRRED && p->body[carrier].inv_mass > 0.0f);
}

// Wakes sleeping body i if a collidable of it is in the region of a field that moves with a body. argument: number of
// fields, in a batch of spots of a bay.
KERNEL(field_wake)
{
	if (p->counters->stalled || p->sleep[i] == 0)
		return;
	int bay = bay_of_body(p, i);
	for (int k = p->continuous_body[i].first; k > 0; k = p->next_collidable[k - 1])
	{
		FieldTraversal traversal = field_traverse(p, bay, p->argument, p->box[k - 1]);
		for (int spot = field_next(p, &traversal); spot >= 0; spot = field_next(p, &traversal))
		{
			const GLOBAL Field* field = p->field + (spot + traversal.fields);
			int carrier = field_carrier(p, field, bay);
			if (carrier >= 0 && carrier != i && field_carried(p, carrier) && field_sees(field, p->filter + k - 1))
				island_wake(p, i, WAKE_WORLD);
		}
	}
}

// Adds the forces of fields on body i to the user's forces. argument: 1 if fields act on shapes, and number of fields, in a
// batch of spots of a bay.
KERNEL(field_body)
{
	i = active_item(p, GROUPS_OF_BODIES, i);
	if (!(p->body[i].inv_mass > 0.0f) || p->stored_velocity[i].stored != 0.0f || p->sleep[i])
		return;
	FieldForce sum = field_nothing();
	for (int k = RUN_LOW(p->argument) ? p->continuous_body[i].first : 0; k > 0; k = p->next_collidable[k - 1])
		if (p->collidable_kind[k - 1] == KIND_DYNAMIC)
			field_add(&sum, p->field_force[k - 1]);
	Float4 pose = field_body_pose(p, i);
	int bay = bay_of_body(p, i), own = i - bay * p->step.bays.bodies;
	FieldTraversal traversal =
	    field_traverse(p, bay, RUN_HIGH(p->argument), make_float4(pose.x, pose.y, pose.x, pose.y));
	for (int spot = field_next(p, &traversal); spot >= 0; spot = field_next(p, &traversal))
		field_act_body(p, i, own, p->field + (spot + traversal.fields), p->field_sample + spot, vec(pose.x, pose.y),
		               &sum);
	field_soften(p, i, &sum);
	command_force(p, i, vec(field_limited(sum.fx + sum.drag_x), field_limited(sum.fy + sum.drag_y)),
	              field_limited(sum.torque + sum.drag_torque));
}

#endif
