// SPDX-License-Identifier: MIT
// channel_output.h -- writes rows of outputs of the worlds of a batch: poses, velocities, touches, joints, rays, visits.
#ifndef CHANNEL_OUTPUT_H
#define CHANNEL_OUTPUT_H
#include "stages/batch/bay_visit.h"
#include "stages/batch/channel_input.h"
#include "stages/read/contact_report.h"
#include "stages/read/joint_report.h"
#include "stages/read/query.h"

INLINE void channel_write4(GLOBAL float* to, Float4 v)
{
	to[0] = v.x;
	to[1] = v.y;
	to[2] = v.z;
	to[3] = v.w;
}

// Writes the velocity of a body, or the stored one of a disabled body.
INLINE void channel_velocity(const Pools* p, int body, GLOBAL float* to)
{
	BodyState now = p->body[body];
	StoredVelocity stored = p->stored_velocity[body];
	int disabled = stored.stored != 0.0f;
	to[0] = disabled ? stored.vx : now.vx;
	to[1] = disabled ? stored.vy : now.vy;
	to[2] = disabled ? stored.w : now.w;
}

// Returns the pose of a body's origin in the frame of another body.
INLINE Float4 channel_relative(const Pools* p, int body, int other)
{
	Float4 a = reported_origin(p, other), b = reported_origin(p, body);
	Vec turn = vec(a.z, a.w), d = vec_turn_back(turn, vec(b.x - a.x, b.y - a.y));
	Vec q = vec_turn_back(turn, vec(b.z, b.w));
	return make_float4(d.x, d.y, q.x, q.y);
}

// s: Returns the time for which a body has been at rest. The user's calls leave values below 0.
INLINE float channel_rest(const Pools* p, int body)
{
	return maximum(p->still[body], p->sleep[body] ? SLEEP_TIME : 0.0f);
}

// Returns whether a contact has a collidable or body as its first one (x) or its second one (y), as bits 1 and 2.
INLINE int channel_ends(Int2 ends, int item) { return (ends.x == item) | (ends.y == item) << 1; }

// Writes zeros to an output whose object the template lacks; another template of the world may have left other values.
INLINE void channel_nothing(const GLOBAL Channel* c, GLOBAL float* to)
{
	for (int k = 0; k < c->missing; ++k)
		to[k] = 0.0f;
}

// Writes a value of a world.
INLINE void channel_world(const Pools* p, int kind, int bay, GLOBAL float* to)
{
	BayState state = p->bay_state[bay];
	if (kind == CHANNEL_GET_NOT_FINITE)
		to[0] = state.nonfinite > 0 ? 1.0f : 0.0f;
	else
		to[0] = bits_float(kind == CHANNEL_GET_OVERLAP ? state.penetration : state.joint_gap);
}

// Item: a group of outputs of bodies, collidables and the world in a live bay. argument: as in channel_group.
KERNEL(channel_body)
{
	ChannelGroup at = channel_group(p, i);
	for (int k = at.first; k < at.end; ++k)
	{
		const GLOBAL Channel* c = at.channels + k;
		GLOBAL float* to = at.row + c->column;
		int first = at.bay * p->step.bays.bodies;
		switch (c->kind)
		{
		case CHANNEL_KINDS:
			channel_nothing(c, to);
			break;
		case CHANNEL_GET_POSE:
			channel_write4(to, reported_origin(p, first + c->item));
			break;
		case CHANNEL_GET_VELOCITY:
			channel_velocity(p, first + c->item, to);
			break;
		case CHANNEL_GET_RELATIVE_POSE:
			channel_write4(to, channel_relative(p, first + c->item, first + c->other));
			break;
		case CHANNEL_GET_REST:
			to[0] = channel_rest(p, first + c->item);
			break;
		case CHANNEL_GET_SENSOR_COUNT:
			to[0] = (float)visit_count(p, at.bay, c->item);
			break;
		case CHANNEL_GET_OVERLAP:
		case CHANNEL_GET_JOINT_GAP:
		case CHANNEL_GET_NOT_FINITE:
			channel_world(p, c->kind, at.bay, to);
			break;
		}
	}
}

// Item: an output of touches in a live bay. argument: as in channel_group. Writes the number of touches of a collidable or body
// (with `other` only, unless it is -1), 1 if there were none in the outputs before, and the sum of their normal impulses in the last
// substep, in the order of slots.
KERNEL(channel_touch)
{
	ChannelGroup at = channel_group(p, i);
	const GLOBAL Channel* c = at.channels + at.first;
	GLOBAL float* to = at.row + c->column;
	if (c->kind == CHANNEL_KINDS)
	{
		channel_nothing(c, to);
		return;
	}
	const Bays* bays = &p->step.bays;
	int bits = bays->contact_bits, touches = 0, whole = c->which & TOUCH_BODY,
	    whole_other = c->which & TOUCH_OTHER_BODY;
	int item = c->item + at.bay * (whole ? bays->bodies : bays->collidables);
	int other = c->other < 0 ? -1 : c->other + at.bay * (whole_other ? bays->bodies : bays->collidables);
	float sum = 0.0f;
	for (int slot = at.bay << bits; slot < (at.bay + 1) << bits; ++slot)
	{
		Int2 pair = p->pair[slot];
		if (pair.x < 0)
			continue;
		Int2 bodies = p->contact_bodies[slot];
		int ends = channel_ends(whole ? bodies : pair, item), others = 3;
		if (other >= 0)
			others = channel_ends(whole_other ? bodies : pair, other);
		// the two are at different ends
		if (!((ends & 1 && others & 2) || (ends & 2 && others & 1)))
			continue;
		Word flags = p->contact_flags[slot];
		if ((flags & (CONTACT_TOUCHING | CONTACT_DETECTED | CONTACT_PENDING)) != CONTACT_TOUCHING)
			continue;
		if ((p->collidable_flags[pair.x] | p->collidable_flags[pair.y]) & COLLIDABLE_RESTARTED)
			continue; // a body was disabled or enabled after the step, or a collidable made a sensor or given another shape
		++touches;
		Float4 impulses = contact_impulses(p, slot);
		sum = sum + (impulses.x + impulses.y);
	}
	to[1] = touches > 0 && to[0] == 0.0f ? 1.0f : 0.0f;
	to[0] = (float)touches;
	to[2] = flush_tiny(sum);
}

// Returns the rotation of a frame of a joint in the world, without its position.
INLINE JointFrame channel_frame(const Pools* p, Float4 frame, int body)
{
	JointFrame at;
	Float4 pose = p->pose[body];
	at.turn = vec_turn(vec(pose.z, pose.w), vec(frame.z, frame.w));
	at.arm = at.position = at.rest = vec(0.0f, 0.0f);
	return at;
}

// Returns the angle of a joint and its speed, as joint_state_now, without the other coordinates. The joint is neither a
// coupling nor on a path.
INLINE JointState channel_angle(const Pools* p, int slot)
{
	JointState now;
	int ia = p->joint_data[slot].body_a, ib = p->joint_data[slot].body_b;
	JointFrame a = channel_frame(p, p->joint_data[slot].frame[0], ia);
	JointFrame b = channel_frame(p, p->joint_data[slot].frame[1], ib);
	now.value[JOINT_ANGLE] = flush_tiny(joint_turned(&a, &b, joint_turned_last(p, slot)));
	now.speed[JOINT_ANGLE] = flush_tiny(number_of(p->body[ib].w - p->body[ia].w));
	return now;
}

// Item: the outputs of a joint in a live bay.
KERNEL(channel_joint)
{
	ChannelGroup at = channel_group(p, i);
	const GLOBAL Channel* channels = at.channels;
	int slot = (at.bay << p->step.bays.joint_bits) + channels[at.first].item, forces = 0, others = 0;
	if (channels[at.first].kind == CHANNEL_KINDS)
	{
		for (int k = at.first; k < at.end; ++k)
			channel_nothing(channels + k, at.row + channels[k].column);
		return;
	}
	for (int k = at.first; k < at.end; ++k)
	{
		forces |= channels[k].kind == CHANNEL_GET_JOINT_FORCE;
		others |= channels[k].which != JOINT_ANGLE;
	}
	others |= forces | ((int)p->joint_data[slot].modes & (JOINT_COUPLED | JOINT_RAILED));
	JointState now = others ? joint_state_now(p, slot, forces) : channel_angle(p, slot);
	for (int k = at.first; k < at.end; ++k)
	{
		GLOBAL float* to = at.row + channels[k].column;
		int which = channels[k].which;
		switch (channels[k].kind)
		{
		case CHANNEL_GET_JOINT_VALUE:
			to[0] = now.value[which];
			break;
		case CHANNEL_GET_JOINT_SPEED:
			to[0] = now.speed[which];
			break;
		default:
			to[0] = now.force_x;
			to[1] = now.force_y;
			to[2] = now.torque;
		}
	}
}

// Item: a ray in a live bay. Writes the fraction of its path at which it meets the first collidable, or 1. The ray moves
// with its body, which it does not meet.
KERNEL(channel_ray)
{
	ChannelGroup at = channel_group(p, i);
	const GLOBAL Channel* c = at.channels + at.first;
	const Bays* bays = &p->step.bays;
	int body = c->item > 0 ? at.bay * bays->bodies + c->item : -1;
	Float4 origin = body >= 0 ? reported_origin(p, body) : make_float4(0.0f, 0.0f, 1.0f, 0.0f);
	if (c->kind == CHANNEL_KINDS)
	{
		channel_nothing(c, at.row + c->column);
		return;
	}
	WorldQuery asked;
	asked.start = vec_flush_tiny(channel_point(origin, c->place.x, c->place.y));
	asked.path = vec_flush_tiny(vec_turn(vec(origin.z, origin.w), vec(c->place.z, c->place.w)));
	asked.turn = vec(1.0f, 0.0f);
	asked.radius = 0.0f;
	Vec end = vec_add(asked.start, asked.path);
	Float4 way = box_union(make_float4(asked.start.x, asked.start.y, asked.start.x, asked.start.y),
	                       make_float4(end.x, end.y, end.x, end.y));
	float nearest = 1.0f;
	for (int k = at.bay * bays->collidables; k < (at.bay + 1) * bays->collidables; ++k)
	{
		int kind = p->collidable_kind[k], of = p->collidable_body[k];
		if (kind == KIND_DEAD || kind & KIND_SENSOR || of < 0 || of == body)
			continue;
		Filter filter = p->filter[k];
		if (!((c->mask & filter.category) && (c->category & filter.mask)))
			continue;
		WorldShape place = collidable_place(p, k);
		QueryResult found = query_nothing();
		if (box_overlap(way, query_box_at(p, place)) &&
		    query_meets(p, query_leaf_of(place, k, 0u), &asked, QUERY_RAYS, &found))
			nearest = minimum(nearest, found.fraction);
	}
	at.row[c->column] = nearest;
}

#endif
