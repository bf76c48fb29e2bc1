// SPDX-License-Identifier: MIT
// island.h -- finds the islands of bodies that touch or are joined, and puts islands at rest to sleep.
//
// Islands are stored only while they sleep. In every SLEEP_STEPS-th step, if some body has been at rest for SLEEP_TIME,
// a union-find labels the bodies that touching contacts and acting joints connect. The label of an island is the lowest
// index of its bodies, so it does not depend on the order of the unions. Bodies that cannot move connect nothing.
//
// This work is based on:
// Jayadharini Jaiganesh and Martin Burtscher, A High-Performance Connected Components Implementation for GPUs, 2018:
// the larger root is hooked under the smaller one by an atomic operation, and paths are halved.
#ifndef ISLAND_H
#define ISLAND_H
#include "stages/color/edge.h"
#include "stages/edit/active.h"
#include "stages/edit/asleep.h"

INLINE int body_can_move(const Pools* p, int i) { return p->body[i].inv_mass > 0.0f; }

// Returns the root of a body, and halves the path to it. Other work-items may link roots at the same time. A path leads
// only to lower indices of the same island, so an old value is also correct.
INLINE int island_root(const Pools* p, int i)
{
	int above = read_shared(p->island + i);
	while (above != i)
	{
		int next = read_shared(p->island + above);
		if (next != above)
			write_shared_word((GLOBAL Word*)p->island + i, (Word)next);
		i = above;
		above = next;
	}
	return i;
}

// Unites the islands of two bodies: links the root with the higher index to the other one.
INLINE void island_unite(const Pools* p, int a, int b)
{
	a = island_root(p, a);
	b = island_root(p, b);
	while (a != b)
	{
		int high = a > b ? a : b, low = a > b ? b : a;
		int before = atomic_min_int(p->island + high, low);
		if (before == high)
			return;
		// another work-item has linked this root meanwhile, so both of its new neighbors are united
		a = before;
		b = low;
	}
}

// Adds ISLAND_* bits to those of body i.
INLINE void island_note(const Pools* p, int i, int bits)
{
	if ((read_shared(p->island_state + i) & bits) != bits)
		atomic_or_int(p->island_state + i, bits);
}

// Unites the two bodies of a constraint. moves: not 0 if one of them is static or kinematic, and moves. begins: not 0
// if the constraint begins in this step.
INLINE void island_link(const Pools* p, Int2 bodies, int moves, int begins)
{
	int bits = (moves ? ISLAND_RESTLESS | ISLAND_STIRRED : 0) | (begins ? ISLAND_STIRRED : 0);
	int a = body_can_move(p, bodies.x), b = body_can_move(p, bodies.y);
	if (bits != 0 && a)
		island_note(p, bodies.x, bits);
	if (bits != 0 && b)
		island_note(p, bodies.y, bits);
	if (a && b)
		island_unite(p, bodies.x, bodies.y);
}

// Returns the item that a search visits as number i. Unless islands wake or are joined, a search visits only active
// groups, and of these only awake bodies: no awake body touches a sleeping one.
INLINE int search_item(const Pools* p, int kind, int i)
{
	return p->counters->search_all ? i : listed_item(p, kind, i);
}

INLINE int search_visits(const Pools* p, int body)
{
	return (p->counters->search_all || p->sleep[body] == 0) && bay_searches(p, body);
}

KERNEL(island_begin)
{
	i = search_item(p, GROUPS_OF_BODIES, i);
	int island = body_island(p, i);
	p->island[i] = island < 0 ? i : island;
	p->island_state[i] = 0;
}

// Returns whether the belt of a contact moves its bodies with at least half of the belt's speed, which may be below the
// threshold. A belt under a body that is held does not.
INLINE int belt_drives_bodies(const Pools* p, int i, Int2 bodies)
{
	float speed = absolute(p->contact_surface[i].w);
	BodyState a = p->body[bodies.x], b = p->body[bodies.y];
	return speed > 0.0f && absolute(b.vx - a.vx) + absolute(b.vy - a.vy) >= 0.5f * speed;
}

KERNEL(contact_link)
{
	i = search_item(p, GROUPS_OF_CONTACTS, i);
	Word flags = p->contact_flags[i];
	if (i >= p->counters->live || (flags & (CONTACT_TOUCHING | CONTACT_DETECTED | CONTACT_PENDING)) != CONTACT_TOUCHING)
		return;
	Int2 pair = p->pair[i], bodies = p->contact_bodies[i];
	if (!search_visits(p, bodies.x) || !search_visits(p, bodies.y))
		return;
	int shifted = (p->collidable_flags[pair.x] | p->collidable_flags[pair.y]) & COLLIDABLE_SHIFTED;
	if (p->step.belts && belt_drives_bodies(p, i, bodies))
	{
		island_note(p, bodies.x, ISLAND_RESTLESS);
		island_note(p, bodies.y, ISLAND_RESTLESS);
	}
	island_link(p, bodies, shifted, p->contact_color[i] == COLOR_NONE && !(flags & CONTACT_ASLEEP));
}

// Returns the velocity of an anchor of a joint. frame: pose of the anchor in the frame of the body.
INLINE Vec anchor_velocity(const Pools* p, int body, Float4 frame)
{
	BodyState state = p->body[body];
	Float4 pose = p->pose[body];
	Float2 center = p->local_center[body];
	Vec arm = vec_turn(vec(pose.z, pose.w), vec(frame.x - center.x, frame.y - center.y));
	return vec_add(vec(state.vx, state.vy), vec_spin(state.w, arm));
}

// Returns whether a motor of a joint turns or moves its bodies with at least half of the motor's speed. A motor that is
// too weak, or that pushes against a limit, does not.
INLINE int joint_drives_bodies(const Pools* p, const GLOBAL JointData* data)
{
	int modes = (int)data->modes, drives = 0;
	float ratio = modes & JOINT_COUPLED ? absolute(data->gear_ratio) : 1.0f;
	float turn_a = p->body[data->body_a].w, turn_b = p->body[data->body_b].w;
	Vec apart =
	    vec_sub(anchor_velocity(p, data->body_b, data->frame[1]), anchor_velocity(p, data->body_a, data->frame[0]));
	float slides = absolute(apart.x) + absolute(apart.y);
	float turns = modes & JOINT_COUPLED ? absolute(turn_b) + ratio * absolute(turn_a) : absolute(turn_b - turn_a);
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		float speed = absolute(data->drive[k].speed);
		float now = modes & JOINT_COUPLED ? slides + turns : k == JOINT_ANGLE ? turns : slides;
		drives |= modes & JOINT_MOTOR(k) && data->drive[k].motor_most > 0.0f && speed > 0.0f && now >= 0.5f * speed;
	}
	return drives;
}

KERNEL(joint_link)
{
	if (!joint_wanted(p->joint_flags[i]))
		return;
	Int2 bodies = make_int2(p->joint_data[i].body_a, p->joint_data[i].body_b);
	if (!search_visits(p, bodies.x) || !search_visits(p, bodies.y))
		return;
	int moves = (!body_can_move(p, bodies.x) && body_is_moving(p, bodies.x)) ||
	            (!body_can_move(p, bodies.y) && body_is_moving(p, bodies.y));
	int drives = (int)p->joint_data[i].modes & (JOINT_MOTOR(0) | JOINT_MOTOR(1) | JOINT_MOTOR(2)) &&
	             joint_drives_bodies(p, p->joint_data + i);
	if (drives)
	{
		island_note(p, bodies.x, ISLAND_RESTLESS);
		island_note(p, bodies.y, ISLAND_RESTLESS);
	}
	island_link(p, bodies, moves, 0);
}

// Returns the ISLAND_* bits that body i adds to those of its island.
INLINE int island_bits(const Pools* p, int i)
{
	// other work-items may add bits to a root at the same time; the root gets all of them, whichever are read here
	int island = body_island(p, i), bits = read_shared(p->island_state + i);
	float still = p->still[i];
	int woken = body_mark(p, i);
	bits |= woken == WAKE_WORLD ? ISLAND_STIRRED : 0;
	if (island >= 0)
		return bits | (woken ? ISLAND_WOKEN : 0) | (still == STILL_FORCED ? ISLAND_FORCED : 0);
	if (!(still >= SLEEP_TIME))
		bits |= ISLAND_RESTLESS;
	if (still == STILL_FORCED)
		bits |= ISLAND_FORCED;
	if (still == STILL_STIRRED)
		bits |= ISLAND_STIRRED;
	return p->sleep_threshold[i] < 0.0f ? bits | ISLAND_RESTLESS | ISLAND_STIRRED : bits;
}

// Returns whether a body can sleep: it can move, and is not disabled.
INLINE int body_takes_part(const Pools* p, int i)
{
	return body_can_move(p, i) && p->stored_velocity[i].stored == 0.0f;
}

KERNEL(island_gather)
{
	i = search_item(p, GROUPS_OF_BODIES, i);
	if (!body_takes_part(p, i) || !search_visits(p, i))
		return;
	island_note(p, island_root(p, i), island_bits(p, i));
}

// Returns whether all bodies of an island sleep from this step on. bits: ISLAND_* bits of its root.
INLINE int island_rests(int bits)
{
	if (bits & ISLAND_FORCED && !(bits & ISLAND_STIRRED))
		return 1;
	return !(bits & (ISLAND_RESTLESS | ISLAND_WOKEN | ISLAND_STIRRED));
}

KERNEL(island_end)
{
	i = search_item(p, GROUPS_OF_BODIES, i);
	if (!body_takes_part(p, i) || !search_visits(p, i))
		return;
	int root = island_root(p, i), rests = island_rests(p->island_state[root]);
	if (!rests && p->sleep[i] == 0)
		return;
	if (rests && body_island(p, i) == root)
	{
		p->still[i] = 0.0f;
		return;
	}
	if (rests)
		body_sleep(p, i, root);
	else
	{
		body_rise(p, i);
		active_touch_body(p, i);
	}
	raise_int(&p->counters->settling, 0x7fffffff);
}

#endif
