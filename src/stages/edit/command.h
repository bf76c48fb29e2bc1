// SPDX-License-Identifier: MIT
// command.h -- applies the user's commands since the last step, those of one item in the order of the calls.
#ifndef COMMAND_H
#define COMMAND_H
#include "constraints/angle.h"
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
		pose_move(p, i, shift, turn);
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

// Sets the velocity that moves a body to a pose in one step, by the shorter rotation, within the limits and locks.
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
	p->pose[i] = pose;
	p->local_center[i] = center;
	p->motion[i].free_x = 1.0f;
	p->motion[i].free_y = 1.0f;
}

// Initializes a new collidable. Its box is empty, so the broad phase finds all of its pairs as new.
INLINE void command_collidable(const Pools* p, int i, Float4 pose, int attribute, int body)
{
	item_clear(p, PER_COLLIDABLE, i);
	p->collidable_pose[i] = pose;
	p->collidable_attribute[i] = attribute;
	p->collidable_body[i] = body;
	p->box[i] = make_float4(EMPTY_LOW, EMPTY_LOW, EMPTY_HIGH, EMPTY_HIGH);
	p->old_box[i] = p->box[i];
}

INLINE Word64 command_word64(float low, float high) { return (Word64)float_word(high) << 32 | (Word64)float_word(low); }

INLINE void command_body_change(const Pools* p, Command c)
{
	int i = c.index;
	Float4 value = c.value;
	switch (c.kind)
	{
	case COMMAND_POSE:
	{
		Vec position = command_center(p, i, value);
		p->pose[i] = make_float4(position.x, position.y, value.z, value.w);
		p->pose_low[i] = make_float2(0.0f, 0.0f);
		break;
	}
	case COMMAND_ENABLED:
		if (!c.whole[0])
		{
			command_rest(p, i);
			break;
		}
		command_wake(p, i);
		p->stored_velocity[i].stored = 0.0f;
		break;
	case COMMAND_TARGET:
		command_target(p, i, value, c.whole[0]);
		break;
	case COMMAND_ARRIVE:
		command_arrive(p, i, value, c.whole[0]);
		break;
	case COMMAND_MASS:
		command_mass(p, i, value);
		break;
	case COMMAND_MOTION:
		command_motion(p, i, value, c.whole[0]);
		break;
	case COMMAND_BODY:
		command_body(p, i, value, make_float2(bits_float(c.whole[0]), bits_float(c.whole[1])));
		break;
	case COMMAND_AWAKE:
		if (c.whole[0] == 0 && p->sleep_threshold[i] >= 0.0f)
			p->still[i] = STILL_FORCED;
		break;
	case COMMAND_SLEEP:
		p->sleep_threshold[i] = value.x;
		if (c.whole[0] != SLEEP_AS_BEFORE)
			p->still[i] = 0.0f;
		if (c.whole[0] == SLEEP_FROM_START)
		{
			body_sleep(p, i, i);
			p->still[i] = STILL_MADE;
		}
		break;
	case COMMAND_CONTINUOUS:
		p->continuous_body[i].first = c.whole[0];
		p->continuous_body[i].parts = c.whole[1];
		p->continuous_body[i].way = value.x;
		p->continuous_body[i].reach = value.y;
		break;
	}
}

INLINE void command_collidable_change(const Pools* p, Command c)
{
	int i = c.index;
	Float4 value = c.value;
	switch (c.kind)
	{
	case COMMAND_PLACE:
		p->collidable_pose[i] = value;
		break;
	case COMMAND_COLLIDABLE:
		command_collidable(p, i, value, c.whole[0], c.whole[1]);
		break;
	case COMMAND_ATTRIBUTE:
		p->collidable_attribute[i] = c.whole[0];
		p->collidable_flags[i] |= COLLIDABLE_CHANGED;
		break;
	case COMMAND_FILTER:
		p->filter[i].category = command_word64(value.x, value.y);
		p->filter[i].mask = command_word64(value.z, value.w);
		p->filter[i].group = c.whole[0];
		p->collidable_kind[i] = c.whole[1] & 255;
		p->filter[i].reports = (Word)c.whole[1] >> 8;
		break;
	case COMMAND_REPORTS:
		p->filter[i].reports = (Word)c.whole[0];
		break;
	case COMMAND_NEXT:
		p->next_collidable[i] = c.whole[0];
		break;
	}
}

// Applies a command. Commands that push a body or set its velocity are handled here, other ones by the functions above.
INLINE void command_change(const Pools* p, Command c)
{
	int i = c.index;
	Float4 value = c.value;
	Vec v = vec(value.x, value.y);
	switch (c.kind)
	{
	case COMMAND_FORCE_AT:
		command_force(p, i, v, command_moment(p, i, v, value.z, value.w));
		break;
	case COMMAND_FORCE:
		command_force(p, i, v, 0.0f);
		break;
	case COMMAND_TORQUE:
		command_force(p, i, vec(0.0f, 0.0f), value.x);
		break;
	case COMMAND_IMPULSE_AT:
		command_spin(p, i, command_moment(p, i, v, value.z, value.w));
		command_push(p, i, v);
		break;
	case COMMAND_IMPULSE:
		command_push(p, i, v);
		break;
	case COMMAND_ANGULAR_IMPULSE:
		command_spin(p, i, value.x);
		break;
	case COMMAND_VELOCITY:
		command_velocity(p, i, v);
		p->body[i].w = value.z;
		break;
	case COMMAND_LINEAR_VELOCITY:
		command_velocity(p, i, v);
		break;
	case COMMAND_SPIN:
		p->body[i].w = value.x;
		break;
	default:
		if (c.kind < COMMAND_PLACE)
			command_body_change(p, c);
		else
			command_collidable_change(p, c);
	}
}

// Returns whether a command wakes a sleeping body. Forces, impulses and velocities of 0 do not.
INLINE int command_stirs(const Pools* p, Command c)
{
	int xy = c.value.x != 0.0f || c.value.y != 0.0f;
	switch (c.kind)
	{
	case COMMAND_FORCE:
	case COMMAND_FORCE_AT:
	case COMMAND_TORQUE:
	case COMMAND_IMPULSE:
	case COMMAND_IMPULSE_AT:
	case COMMAND_ANGULAR_IMPULSE:
	case COMMAND_LINEAR_VELOCITY:
	case COMMAND_SPIN:
		return xy;
	case COMMAND_VELOCITY:
		return xy || c.value.z != 0.0f;
	case COMMAND_MASS:
	case COMMAND_JOINTS:
		return p->still[c.index] != STILL_MADE;
	case COMMAND_POSE:
	case COMMAND_MOTION:
	case COMMAND_ENABLED:
	case COMMAND_TARGET:
		return 1;
	case COMMAND_AWAKE:
		return c.whole[0];
	case COMMAND_SLEEP:
		return c.value.x < 0.0f;
	default:
		return 0;
	}
}

// Marks the island of a body that the user changes, and wakes the body itself at once, so that later commands act on
// it. joined: not 0 for a static or kinematic body with joints; joint_wake then marks the islands at these joints.
INLINE void command_stir(const Pools* p, int i, int joined)
{
	if (p->sleep[i])
	{
		island_wake(p, i, WAKE_USER);
		body_rise(p, i);
		raise_int(&p->counters->touched, 0x7fffffff);
	}
	else if (joined)
		raise_int(&p->counters->woken, 0x7fffffff);
	p->still[i] = joined ? STILL_MOVED : STILL_STIRRED;
}

INLINE void command_apply(const Pools* p, Command c)
{
	int disabled = c.kind < COMMAND_BODY && c.whole[1] & COMMAND_DISABLED;
	if (command_stirs(p, c))
		command_stir(p, c.index, c.whole[1] & COMMAND_JOINED);
	if (disabled)
		command_wake(p, c.index);
	command_change(p, c);
	if (disabled)
		command_rest(p, c.index);
}

#define COMMAND_SOON 6 // prefetch distance, in groups

// Item: a group of commands: all those of one body or one collidable. argument: number of groups.
KERNEL(command)
{
	if (FETCHES && i + COMMAND_SOON < p->argument)
	{
		int first = p->command_group[i + COMMAND_SOON], soon = p->command[first].index;
		if (p->command[first].kind == COMMAND_BODY)
			item_fetch(p, PER_BODY, soon);
		if (p->command[first].kind == COMMAND_COLLIDABLE)
			item_fetch(p, PER_COLLIDABLE, soon);
	}
	for (int k = p->command_group[i]; k < p->command_group[i + 1]; ++k)
		command_apply(p, p->command[k]);
}

#endif
