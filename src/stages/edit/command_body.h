// SPDX-License-Identifier: MIT
// command_body.h -- changes bodies as the user's commands say: velocities, forces, masses, poses.
#ifndef COMMAND_BODY_H
#define COMMAND_BODY_H
#include "constraints/angle.h"
#include "constraints/constraint_kinds.h"
#include "constraints/sweep_closing.h"
#include "stages/edit/asleep.h"
#include "stages/edit/pool_item.h"
#include "stages/geometry/pose.h"

// Sets the linear velocity of a body: 0 along locked axes, and the largest float in place of an infinite component.
INLINE void command_velocity(const Pools* p, int body, Vec v)
{
	p->body[body].vx = p->motion[body].free_x == 0.0f ? 0.0f : finite_or_most(v.x);
	p->body[body].vy = p->motion[body].free_y == 0.0f ? 0.0f : finite_or_most(v.y);
}

INLINE void command_spin(const Pools* p, int body, float impulse)
{
	p->body[body].w = finite_or_most(p->body[body].w + p->body[body].inv_inertia * impulse);
}

INLINE void command_force(const Pools* p, int body, Vec force, float torque)
{
	GLOBAL Motion* motion = p->motion + body;
	motion->fx = finite_or_most(motion->fx + force.x);
	motion->fy = finite_or_most(motion->fy + force.y);
	motion->torque = finite_or_most(motion->torque + torque);
}

INLINE void command_push(const Pools* p, int body, Vec impulse)
{
	BodyState state = p->body[body];
	command_velocity(p, body, vec_add(vec(state.vx, state.vy), vec_scale(state.inv_mass, impulse)));
}

// Returns the moment, about the center of mass, of a force or impulse at a world point. If a product overflows,
// computes the moment from a force 2^64 times smaller, because the difference of two infinite products would be NaN.
OUT_OF_LINE float command_moment(const Pools* p, int body, Vec force, float x, float y)
{
	Float4 pose = p->pose[body];
	Vec arm = vec(x - pose.x, y - pose.y);
	float moment = vec_cross(arm, force);
	if (moment - moment == 0.0f)
		return moment;
	return finite_or_most(1.8446744e19f * vec_cross(arm, vec_scale(5.4210109e-20f, force)));
}

// Sets inverse mass, inverse inertia and center of mass. The velocity becomes that of the body at the new center.
INLINE void command_mass(const Pools* p, int i, Float4 value)
{
	Float2 old = p->local_center[i];
	Vec turn = vec(p->pose[i].z, p->pose[i].w), shift = vec_turn(turn, vec(value.z - old.x, value.w - old.y));
	BodyState state = p->body[i];
	Vec v = vec_add(vec(state.vx, state.vy), vec_spin(state.w, shift));
	p->local_center[i] = make_float2(value.z, value.w);
	// adding 0 would turn a coordinate of -0 into 0
	if (shift.x != 0.0f || shift.y != 0.0f)
	{
		Float4 start = p->start_pose[i];
		Vec before = vec_turn(vec(start.z, start.w), vec(value.z - old.x, value.w - old.y));
		p->start_pose[i] = make_float4(start.x + before.x, start.y + before.y, start.z, start.w);
		pose_move(p, i, shift, turn);
	}
	if (value.x == 0.0f)
		body_stand(p, i);
	if (p->body[i].inv_mass != value.x &&
	    layout_has_spokes(p->counters)) // masses decide which body is a hub (hub_owner)
		raise_int(&p->counters->stale_layout[CONSTRAINT_CONTACT], 1);
	p->body[i].inv_mass = value.x;
	p->body[i].inv_inertia = value.y;
	command_velocity(p, i, v);
}

// Sets the values of body_values.def and the locks; velocities along locks become 0. locks: 1: x; 2: y; 4: rotation.
INLINE void command_motion(const Pools* p, int i, Float4 value, int locks)
{
	GLOBAL Motion* motion = p->motion + i;
	const float values[4] = {value.x, value.y, value.z, value.w};
	int k = 0;
#define X(name, least, most, value) motion->name = values[k++];
#include "pools/body_values.def"
	motion->free_x = locks & 1 ? 0.0f : 1.0f;
	motion->free_y = locks & 2 ? 0.0f : 1.0f;
	command_velocity(p, i, vec(p->body[i].vx, p->body[i].vy));
	if (locks & 4)
		p->body[i].w = 0.0f;
}

// Disables a body: stores its velocity in the pool stored_velocity; sets velocity, forces and gravity scale to 0.
INLINE void command_rest(const Pools* p, int i)
{
	BodyState state = p->body[i];
	GLOBAL Motion* motion = p->motion + i;
	StoredVelocity stored = {state.vx, state.vy, state.w, 1.0f};
	p->stored_velocity[i] = stored;
	body_stand(p, i);
	p->body[i].vx = 0.0f;
	p->body[i].vy = 0.0f;
	p->body[i].w = 0.0f;
	motion->fx = 0.0f;
	motion->fy = 0.0f;
	motion->torque = 0.0f;
	motion->gravity_scale = 0.0f;
}

// Restores the stored velocity of a disabled body, before a command that changes or enables the body.
INLINE void command_wake(const Pools* p, int i)
{
	StoredVelocity stored = p->stored_velocity[i];
	p->body[i].vx = stored.vx;
	p->body[i].vy = stored.vy;
	p->body[i].w = stored.w;
}

// Returns the center of mass of a body whose origin is at a pose.
INLINE Vec command_center(const Pools* p, int i, Float4 pose)
{
	Float2 center = p->local_center[i];
	return vec_add(vec(pose.x, pose.y), vec_turn(vec(pose.z, pose.w), vec(center.x, center.y)));
}

// Sets the velocity that moves a body to a pose in one step, by the shorter rotation, within the limits and locks. A
// refused step takes it back, so it leaves no mark of sleep at the body; joint_wake sees the velocity.
INLINE void command_target(const Pools* p, int i, Float4 target, int locks)
{
	Float4 pose = p->pose[i];
	Float2 low = p->pose_low[i];
	Vec to = command_center(p, i, target);
	float rate = quotient(1.0f, p->step.dt);
	Vec v = vec(((to.x - pose.x) - low.x) * rate, ((to.y - pose.y) - low.y) * rate);
	float turn = vec_angle(vec_turn_back(vec(pose.z, pose.w), vec(target.z, target.w)));
	command_velocity(p, i, sweep_velocity(&p->step, v));
	p->body[i].w = locks & 4 ? 0.0f : flush_tiny(within(turn * rate, p->step.max_spin));
	if (p->step.sleep) // the body's groups may rest since steps with dt 0, which keep its target
		active_touch_body(p, i);
}

// Moves a body to a pose, except along its locks, and sets its velocity to 0.
INLINE void command_arrive(const Pools* p, int i, Float4 target, int locks)
{
	Float4 pose = p->pose[i];
	Float2 low = p->pose_low[i];
	if (locks & 4)
		target = make_float4(target.x, target.y, pose.z, pose.w);
	Vec to = command_center(p, i, target);
	p->pose[i] = make_float4(locks & 1 ? pose.x : to.x, locks & 2 ? pose.y : to.y, target.z, target.w);
	p->pose_low[i] = make_float2(locks & 1 ? low.x : 0.0f, locks & 2 ? low.y : 0.0f);
	p->body[i].vx = 0.0f;
	p->body[i].vy = 0.0f;
	p->body[i].w = 0.0f;
}

// Destroys a body, or initializes a new body at rest, without mass, forces or locks. pose: pose of the center of mass.
INLINE void command_body(const Pools* p, int i, Float4 pose, Float2 center)
{
	body_gone_wake(p, i);
	item_clear(p, PER_BODY, i);
	p->reported_pose[i] = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	body_stand(p, i);
	p->pose[i] = pose;
	p->local_center[i] = center;
	p->motion[i].free_x = 1.0f;
	p->motion[i].free_y = 1.0f;
}

#endif
