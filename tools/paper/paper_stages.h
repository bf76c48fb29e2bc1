// SPDX-License-Identifier: MIT
// paper_stages.h -- defines the three stages of the paper's pipeline that run on the device.
//
// This work is based on: Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines, section III.
//
// PAPER_STAGE(name) begins a function for item i of the pools p. Each file that includes this header defines the macro
// so that the stage runs for all items.
#ifndef PAPER_STAGES_H
#define PAPER_STAGES_H
#include "constraints/solver_body.h"
#include "stages/geometry/filter.h"
#include "stages/geometry/manifold.h"
#include "tools/paper/paper_pools.h"

// Integrates forces to velocity, and velocity to position (semi-implicit Euler). Then clears the forces and applies
// damping.
PAPER_STAGE(integrate)
{
	GLOBAL PaperBody* body = p->body + i;
	Motion motion = body->motion;
	float dt = p->step.dt;
	Vec force = vec_scale(body->inv_mass, vec(motion.fx, motion.fy));
	Vec gravity = vec_scale(motion.gravity_scale, vec(p->step.gravity_x, p->step.gravity_y));
	Vec v = vec_add(vec(body->vx, body->vy), vec_scale(dt, vec_add(force, gravity)));
	v = vec(motion.free_x * v.x, motion.free_y * v.y);
	float w = body->w + dt * (body->inv_inertia * motion.torque);

	Float4 pose = body->pose;
	Body turned;
	turned.da = dt * w;
	if (turned.da != 0.0f)
	{
		// normalizes the rotation, because rounding errors would change its length
		body_turn(&turned);
		Vec q = vec_turn(vec(1.0f + turned.versine, turned.sine), vec(pose.z, pose.w));
		q = vec_scale(1.0f / square_root(vec_dot(q, q)), q);
		pose.z = q.x;
		pose.w = q.y;
	}
	body->pose = make_float4(pose.x + dt * v.x, pose.y + dt * v.y, pose.z, pose.w);

	body->motion.fx = 0.0f;
	body->motion.fy = 0.0f;
	body->motion.torque = 0.0f;
	v = vec_scale(1.0f / (1.0f + dt * motion.linear_damping), v);
	body->vx = v.x;
	body->vy = v.y;
	body->w = w / (1.0f + dt * motion.angular_damping);
}

// Transforms the corners and edge normals of the attribute to world coordinates, once for all pairs of the collidable.
PAPER_STAGE(transform)
{
	GLOBAL PaperCollidable* collidable = p->collidable + i;
	const GLOBAL Attribute* attribute = p->attribute + collidable->attribute;
	Frame frame;
	frame.position = vec(collidable->place.x, collidable->place.y);
	frame.rotation = vec(collidable->place.z, collidable->place.w);
	if (collidable->body >= 0)
	{
		Float4 pose = p->body[collidable->body].pose;
		Frame body;
		body.position = vec(pose.x, pose.y);
		body.rotation = vec(pose.z, pose.w);
		frame.position = frame_point(body, frame.position);
		frame.rotation = vec_turn(body.rotation, frame.rotation);
	}
	collidable->instance = *attribute;
	for (int k = 0; k < attribute->count; ++k)
	{
		Vec corner = frame_point(frame, shape_corner(attribute, k));
		Vec normal = vec_turn(frame.rotation, shape_normal(attribute, k));
		collidable->instance.vertices[k] = make_float2(corner.x, corner.y);
		collidable->instance.normals[k] = make_float2(normal.x, normal.y);
	}
}

INLINE int may_touch(const GLOBAL PaperCollidable* a, const GLOBAL PaperCollidable* b)
{
	return kinds_meet(a->kind, b->kind) && (a->body < 0 || a->body != b->body) && filter_accepts(a->filter, b->filter);
}

// Tests a collidable against all later collidables. An atomic counter gives slots of the contact pool to contacts, so
// their order depends on the device. The paper keeps this order; here the host sorts the contacts afterwards.
PAPER_STAGE(detect)
{
	const GLOBAL PaperCollidable* a = p->collidable + i;
	for (int j = i + 1; j < p->step.collidables; ++j)
	{
		const GLOBAL PaperCollidable* b = p->collidable + j;
		if (!may_touch(a, b))
			continue;

		// both instances are already in world coordinates, so the frame is the identity
		Manifold m = collide(&a->instance, &b->instance, frame_at(vec(0.0f, 0.0f), vec(1.0f, 0.0f)),
		                     reach_of(SPECULATIVE_DISTANCE));
		if (m.count == 0 || !(minimum(m.separation[0], m.separation[1]) < 0.0f))
			continue;
		int slot = atomic_add_int(p->contact_count, 1);
		if (slot >= p->step.contact_capacity)
			continue;

		PaperContact contact;
		contact.a = i;
		contact.b = j;
		contact.body_a = a->body;
		contact.body_b = b->body;
		contact.normal = make_float2(m.normal.x, m.normal.y);
		for (int k = 0; k < 2; ++k)
		{
			contact.point[k] = make_float2(m.point[k].x, m.point[k].y);
			contact.separation[k] = m.separation[k];
		}
		contact.friction = square_root(a->instance.friction * b->instance.friction);
		contact.restitution = maximum(a->instance.restitution, b->instance.restitution);
		contact.count = m.count;
		contact.unused = 0;
		p->contact[slot] = contact;
	}
}

#endif
