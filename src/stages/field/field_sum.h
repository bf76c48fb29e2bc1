// SPDX-License-Identifier: MIT
// field_sum.h -- computes the poses at which fields act on bodies, and sums the forces of fields on a body.
//
// Fields act once per step, at the poses that bodies reach without fields after (n - 1) / 2 of n substeps. So a step is
// a leapfrog step (drift, kick, drift), and orbits keep their energy (docs/design/fields.md, When fields act).
//
// This work is based on:
// Ernst Hairer, Christian Lubich, Gerhard Wanner, Geometric Numerical Integration, 2006, I.1.4: Stoermer and Verlet.
#ifndef FIELD_SUM_H
#define FIELD_SUM_H
#include "pools/bays.h"
#include "stages/broad_phase/transform.h"

#define FIELD_MOST 1.0e35f // N or N m: limit of each force component and of the torque of all fields on a body

// s: time from the start of a step to the poses at which fields act
INLINE float field_ahead(const Pools* p) { return 0.5f * (p->step.dt - p->step.h); }

// Returns the pose of a body's center of mass at the time field_ahead, predicted from its velocity.
INLINE Float4 field_body_pose(const Pools* p, int body)
{
	BodyState state = p->body[body];
	Float4 pose = p->pose[body];
	float ahead = field_ahead(p);
	Vec turn = vec_turn(vec_rotation(ahead * state.w), vec(pose.z, pose.w));
	return make_float4(pose.x + ahead * state.vx, pose.y + ahead * state.vy, turn.x, turn.y);
}

// Transforms the pose `own` from a body's frame to the world. *arm, m: vector from the center of mass to this pose.
INLINE Float4 field_body_point(const Pools* p, int body, Float4 own, Vec* arm)
{
	Float4 pose = field_body_pose(p, body);
	Float2 middle = p->local_center[body];
	Vec turn = vec(pose.z, pose.w), rotation = vec_turn(turn, vec(own.z, own.w));
	*arm = vec_turn(turn, vec(own.x - middle.x, own.y - middle.y));
	return make_float4(pose.x + arm->x, pose.y + arm->y, rotation.x, rotation.y);
}

// Returns the body that carries a field in the world of a bay, -1 for none.
INLINE int field_carrier(const Pools* p, const GLOBAL Field* field, int bay)
{
	return field->body < 0 ? -1 : bay * p->step.bays.bodies + field->body;
}

// carrier: body that carries the field, -1 for none.
INLINE FieldSample field_sample_of(const Pools* p, const GLOBAL Field* field, int carrier)
{
	FieldSample spot = {field->pose, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, {0.0f, 0.0f, 0.0f}};
	if (carrier >= 0)
	{
		Vec arm;
		spot.pose = field_body_point(p, carrier, field->pose, &arm);
		spot.center_x = -arm.x;
		spot.center_y = -arm.y;
		spot.vx = p->body[carrier].vx;
		spot.vy = p->body[carrier].vy;
		spot.w = p->body[carrier].w;
	}
	return spot;
}

INLINE Vec field_turn(const FieldSample* spot, float x, float y)
{
	return vec_turn(vec(spot->pose.z, spot->pose.w), vec(x, y));
}

// Returns the velocity of the medium at a point.
INLINE Vec field_flow(const GLOBAL Field* field, const FieldSample* spot, Vec at)
{
	Vec arm = vec((at.x - spot->pose.x) - spot->center_x, (at.y - spot->pose.y) - spot->center_y);
	Vec own = vec_add(vec(spot->vx, spot->vy), vec_spin(spot->w, arm));
	return vec_add(own, field_turn(spot, field->velocity_x, field->velocity_y));
}

INLINE int field_holds(const GLOBAL Field* field, const FieldSample* spot, Vec at)
{
	const GLOBAL Attribute* shape = &field->shape;
	Vec q = vec_turn_back(vec(spot->pose.z, spot->pose.w), vec(at.x - spot->pose.x, at.y - spot->pose.y));
	int inside = shape->count > 2;
	float nearest = MOST_FLOAT; // square of the distance to the nearest edge, m^2
	for (int k = 0; k < shape->count; ++k)
	{
		Float2 a = shape->vertices[k], b = shape->vertices[k + 1 < shape->count ? k + 1 : 0],
		       normal = shape->normals[k];
		Vec from = vec(q.x - a.x, q.y - a.y), edge = vec(b.x - a.x, b.y - a.y);
		float along = vec_dot(from, edge), length = vec_dot(edge, edge);
		float share = along > 0.0f && length > 0.0f ? minimum(quotient(along, length), 1.0f) : 0.0f;
		Vec apart = vec_sub(from, vec_scale(share, edge));
		nearest = minimum(nearest, vec_dot(apart, apart));
		inside = inside && vec_dot(from, vec(normal.x, normal.y)) <= 0.0f;
	}
	return shape->count == 0 || inside || nearest <= shape->radius * shape->radius;
}

INLINE int field_sees(const GLOBAL Field* field, const GLOBAL Filter* filter)
{
	return (field->mask & filter->category) != 0 && (filter->mask & field->category) != 0;
}

typedef struct // state of a loop over the fields whose boxes overlap `box`, by rising index
{
	Float4 box;
	int count;        // number of fields; in a batch, of spots of a bay
	int fields;       // number to add to a spot to get the field
	int begin;        // first group of ARITY spots of the world
	int next;         // next block to test: of ARITY boxes or, with more than FIELD_FEW fields, of ARITY groups
	int group, first; // first group of the current block of groups; first box of the current block of boxes
	Word groups, hits;
} FieldTraversal;

// bay: bay of the world. count: as FieldTraversal.count.
INLINE FieldTraversal field_traverse(const Pools* p, int bay, int count, Float4 box)
{
	FieldTraversal traversal = {box, count, 0, 0, 0, 0, 0, 0u, 0u};
	if (BATCHED(p))
	{
		traversal.fields = p->bay[bay].field - bay * count;
		traversal.begin = bay * (count / ARITY);
	}
	return traversal;
}

// Clears the lowest set bit of a mask that is not 0. Returns the number of this bit.
INLINE int field_take(Word* bits)
{
	int k = 0;
	while (!(*bits >> k & 1))
		++k;
	*bits = *bits & ~(1u << k);
	return k;
}

// Returns the spot of the next field, -1 after the last one. Outside of a batch, this is the index of the field.
INLINE int field_next(const Pools* p, FieldTraversal* w)
{
	int few = w->count <= FIELD_FEW, step = few ? ARITY : ARITY * ARITY;
	while (!w->hits)
	{
		if (!w->groups)
		{
			if (w->next * step >= w->count)
				return -1;
			w->group = w->begin + (few ? w->next : ARITY * w->next);
			w->groups = few ? 1u : overlaps8(p->field_group + w->group, w->box);
			++w->next;
			continue;
		}
		w->first = ARITY * (w->group + field_take(&w->groups));
		w->hits = overlaps8(p->field_box + w->first, w->box);
	}
	return w->first + field_take(&w->hits);
}

INLINE FieldForce field_nothing(void)
{
	FieldForce sum = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, {0.0f, 0.0f}};
	return sum;
}

// Adds a force at a point, and its torque, to the sum. arm, m: vector from the body's center of mass to the point.
INLINE void field_push(FieldForce* sum, Vec arm, Vec force)
{
	sum->fx = sum->fx + force.x;
	sum->fy = sum->fy + force.y;
	sum->torque = sum->torque + vec_cross(arm, force);
}

// Adds the drag of a medium at a point to the sum. rate, kg/s: force divided by the medium's speed past the point.
INLINE void field_brake(FieldForce* sum, Vec arm, float rate, Vec force)
{
	sum->drag_x = sum->drag_x + force.x;
	sum->drag_y = sum->drag_y + force.y;
	sum->drag_torque = sum->drag_torque + vec_cross(arm, force);
	sum->rate = sum->rate + rate;
	sum->rate_x = sum->rate_x + rate * arm.x;
	sum->rate_y = sum->rate_y + rate * arm.y;
	sum->rate_w = sum->rate_w + rate * vec_dot(arm, arm);
}

// Adds the torque of a medium that rotates faster than the body by `spin`, rad/s. rate, kg m^2/s: torque / spin.
INLINE void field_brake_spin(FieldForce* sum, float rate, float spin)
{
	sum->drag_torque = sum->drag_torque + rate * spin;
	sum->rate_w = sum->rate_w + rate;
}

INLINE void field_add(FieldForce* sum, FieldForce f)
{
	sum->fx = sum->fx + f.fx;
	sum->fy = sum->fy + f.fy;
	sum->torque = sum->torque + f.torque;
	sum->drag_x = sum->drag_x + f.drag_x;
	sum->drag_y = sum->drag_y + f.drag_y;
	sum->drag_torque = sum->drag_torque + f.drag_torque;
	sum->rate = sum->rate + f.rate;
	sum->rate_x = sum->rate_x + f.rate_x;
	sum->rate_y = sum->rate_y + f.rate_y;
	sum->rate_w = sum->rate_w + f.rate_w;
}

// Returns the share of drag that stops a body within a step. slow: part of its speed that all of the drag would take. A
// share is never a denormal, because drag may be infinite.
INLINE float field_share(float slow) { return slow > 1.0f ? quotient(1.0f, minimum(slow, FIELD_MOST)) : 1.0f; }

// Limits strong drag, which would otherwise reverse the velocity relative to the medium within the step. First the
// linear and the angular part are limited separately. Then both are scaled by a common factor, so that drag never adds
// energy. Drag below these limits is unchanged, so the speed at which it balances a force is exact.
OUT_OF_LINE void field_soften(const Pools* p, int body, FieldForce* sum)
{
	BodyState state = p->body[body];
	Motion motion = p->motion[body];
	float dt = p->step.dt, slow = dt * (sum->rate * state.inv_mass), slow_w = dt * (sum->rate_w * state.inv_inertia);
	float linear = field_share(slow), angular = field_share(slow_w);
	float fx = flush_below(linear * sum->drag_x, ABSORBS), fy = flush_below(linear * sum->drag_y, ABSORBS),
	      torque = flush_below(angular * sum->drag_torque, ABSORBS), share = 1.0f;
	float ax = motion.free_x * state.inv_mass * fx, ay = motion.free_y * state.inv_mass * fy,
	      aw = state.inv_inertia * torque, most = maximum(maximum(absolute(ax), absolute(ay)), absolute(aw));
	if (most > 1.0e-30f && most < FIELD_MOST)
	{
		float unit = quotient(1.0f, most); // scales all accelerations to at most 1, so that their squares are finite
		float dx = flush_tiny(unit * ax), dy = flush_tiny(unit * ay), dw = flush_tiny(unit * aw);
		float gain = unit * sum->drag_x * dx + unit * sum->drag_y * dy + unit * sum->drag_torque * dw;
		float loss =
		    sum->rate * (dx * dx + dy * dy) + 2.0f * dw * (sum->rate_x * dy - sum->rate_y * dx) + sum->rate_w * dw * dw;
		share = dt * loss > gain && gain >= ABSORBS ? quotient(gain, dt * loss) : 1.0f;
	}
	sum->drag_x = share * fx;
	sum->drag_y = share * fy;
	sum->drag_torque = share * torque;
}

INLINE float field_limited(float x) { return within(number_of(x), FIELD_MOST); }

#endif
