// SPDX-License-Identifier: MIT
// joint_edges.h -- applies changes of joints, begins and ends their constraints, lists bodies that must not touch.
#ifndef JOINT_EDGES_H
#define JOINT_EDGES_H
#include "constraints/joint_one.h"
#include "stages/color/edge.h"
#include "stages/color/key_bound.h"
#include "stages/color/touch.h"
#include "stages/geometry/box.h"

// Changes the angle of a joint that gets its first limit, spring or lock of the angle: adds whole turns, so that it is
// as near as possible to the limits or the target.
INLINE void joint_count_turns(const Pools* p, int slot, const JointData* changed)
{
	int k = JOINT_ANGLE, users = JOINT_COUNTED(k), place = p->joint_place[slot];
	int modes = (int)changed->modes;
	if ((int)p->joint_data[slot].modes & users || !(modes & users))
		return;
	float turned = joint_turned_last(p, slot), near = changed->lock[k].target;
	if (modes & JOINT_LIMITED(k))
		near = minimum(maximum(turned, changed->drive[k].lower), changed->drive[k].upper);
	turned = turned - TURN * joint_round((turned - near) * (1.0f / TURN));
	if (place < 0)
		p->joint_kept[slot].turned = turned;
	else
		joint_row(p, turned, place) = turned;
}

// Requests a search of the whole path in the next step, because the user placed a body or a frame of the joint.
INLINE void joint_seek(const Pools* p, int slot)
{
	PathCount count = path_count_last(p, slot);
	count.seeks = maximum(count.seeks, PATH_SEEKS);
	path_count_store(p, slot, p->joint_place[slot], &count);
}

// Item: a joint that the user created or changed. argument: number of joint slots in use before these edits. A joint
// that broke stays broken, unless it was replaced by a new one.
KERNEL(joint_apply)
{
	JointEdit edit = p->joint_edit[i];
	int slot = edit.slot;
	if (slot >= p->argument)
	{
		p->joint_color[slot] = COLOR_NONE;
		p->joint_place[slot] = -1;
	}
	else if (!(edit.flags & JOINT_NEW))
		edit.flags |= p->joint_flags[slot] & JOINT_KEPT_BITS;
	if (slot < p->argument && (edit.flags & (JOINT_THERE | JOINT_NEW)) == JOINT_THERE)
	{
		joint_count_turns(p, slot, &edit.data);
		if (edit.flags & JOINT_SEEKS)
			joint_seek(p, slot);
	}
	edit.flags &= ~JOINT_SEEKS;
	if (slot >= p->argument || p->joint_spot[slot] != edit.spot)
		raise_int(&p->counters->joint_moved, 1);
	p->joint_spot[slot] = edit.spot;
	p->joint_flags[slot] = edit.flags;
	p->joint_data[slot] = edit.data;
	raise_int(&p->counters->joints, slot + 1);
	raise_int(&p->counters->joints_dirty, 0x7fffffff);
}

// Ends the constraint of joint i. Stores its counts of turns and laps, which apply if it begins again.
INLINE void joint_rest(const Pools* p, int i)
{
	float turned = joint_turned_last(p, i);
	CouplingCount count = coupling_count_last(p, i);
	PathCount path = path_count_last(p, i);
	joint_end(p, i);
	p->joint_kept[i].turned = turned;
	coupling_count_store(p, i, -1, &count);
	// requests a search of the whole path, because the bodies may be anywhere when the joint begins again
	path.seeks = maximum(path.seeks, PATH_SEEKS);
	path_count_store(p, i, -1, &path);
}

// Returns whether a joint acts, unless its bodies sleep.
INLINE int joint_wanted(int flags)
{
	int wanted = JOINT_THERE | JOINT_ACTIVE | JOINT_ACTS;
	return (flags & (wanted | JOINT_BROKEN)) == wanted;
}

// Begins the constraint of joint i, and returns it as edge_begin does.
INLINE int joint_begin(const Pools* p, int i)
{
	p->joint_bodies[i] = make_int2(p->joint_data[i].body_a, p->joint_data[i].body_b);
	return edge_begin(p, edge_of(CONSTRAINT_JOINT, i), p->joint_bodies[i]);
}

// Begins or ends the constraint of joint i, or both if the joint must begin again.
LIST_KERNEL(joint_update, began, began)
{
	int flags = p->joint_flags[i], wanted = joint_wanted(flags);
	if (p->counters->stalled)
		return EDGE_NONE;
	if (!wanted || flags & JOINT_BEGINS_AGAIN)
		joint_rest(p, i);
	if (p->counters->joint_moved || flags & JOINT_BEGINS_AGAIN)
		edge_mark_dirty(p, CONSTRAINT_JOINT);
	p->joint_flags[i] = flags & ~(JOINT_BEGINS_AGAIN | JOINT_NEW);
	if (!wanted || p->joint_color[i] != COLOR_NONE)
		return EDGE_NONE;
	if (!(p->sleep[p->joint_data[i].body_a] | p->sleep[p->joint_data[i].body_b]))
		return joint_begin(p, i);
	p->joint_flags[i] |= JOINT_ASLEEP;
	return EDGE_NONE;
}

// Item: a joint. For a joint on a path, finds the point of the path that is nearest to anchor b. For a coupling,
// measures its bodies. Runs after the layout. Repeated runs give the same result.
KERNEL(joint_follow)
{
	int place = p->joint_place[i], modes = (int)p->joint_data[i].modes;
	if (p->counters->stalled) // the counts are a part of the state, which a refused step leaves as it was
		return;
	if (place >= 0 && modes & JOINT_COUPLED)
		coupling_setup(p, place);
	if (place < 0 || !(modes & JOINT_RAILED))
		return;
	PathCount count = path_count_at(p, place);
	PathFoot foot = path_follow(p, i, &count);
	path_foot_put(p, place, &foot);
	path_count_put(p, place, &count);
}

KERNEL(joint_updated)
{
	if (!p->counters->stalled)
		p->counters->joints_dirty = p->counters->joint_moved = 0;
	(void)i;
}

INLINE Word64 joint_pair_of(int a, int b)
{
	int low = a < b ? a : b, high = a < b ? b : a;
	return (Word64)low << 32 | (Word64)high;
}

// Writes the key of the two bodies that joint i keeps from touching; NO_PAIR if they may touch.
KERNEL(joint_pair_key)
{
	int flags = p->joint_flags[i], apart = JOINT_THERE | JOINT_COLLIDES | JOINT_BROKEN;
	p->key[i] =
	    (flags & apart) == JOINT_THERE ? joint_pair_of(p->joint_data[i].body_a, p->joint_data[i].body_b) : NO_PAIR;
}

// Writes the key of excluded pair i, behind the keys of the joints. argument: number of joints.
KERNEL(excluded_key) { p->key[p->argument + i] = p->excluded[i]; }

KERNEL(excluded_changed)
{
	raise_int(&p->counters->joints_dirty, 0x7fffffff);
	(void)i;
}

// Item: a sorted key. Copies the key, and counts the keys that are not NO_PAIR. argument: number of all keys.
KERNEL(joint_pair)
{
	Word64 key = p->key[i];
	p->joined[i] = key;
	if (key != NO_PAIR && (i + 1 == p->argument || p->key[i + 1] == NO_PAIR))
		p->counters->joined = i + 1;
	if (i == 0 && key == NO_PAIR)
		p->counters->joined = 0;
}

// Returns whether a joint or the user keeps two bodies from touching.
INLINE int joint_parts(const Pools* p, Int2 bodies)
{
	Word64 key = joint_pair_of(bodies.x, bodies.y);
	int count = p->counters->joined, at = key_bound(p->joined, 0, count, key);
	return at < count && p->joined[at] == key;
}

// Item: a place of joints. Lists the joint as an event if its force or torque exceeded its threshold, and breaks it if
// it can break. Counts the turns of a coupling with the ratio of this step, because the user may change the ratio.
KERNEL(joint_finalize)
{
	// the host may not have read the layout yet
	if (BATCHED(p) && i >= p->counters->layout[CONSTRAINT_JOINT].begin[COLORS + 1])
		return;
	int slot = p->joint_place_slot[i];
	if (slot < 0)
		return;
	const GLOBAL JointData* data = p->joint_data + slot;
	if ((int)data->modes & JOINT_COUPLED)
	{
		CouplingCount count = coupling_count_at(p, i);
		coupling_state(p, slot, &count);
		coupling_count_put(p, i, &count);
	}
	JointEvent event;
	event.slot = slot;
	// a joint without a threshold has the largest float as its threshold. No value may exceed it: forces are computed
	// only in worlds with thresholds, and a step must not depend on the thresholds of other joints
	event.force = finite_or_most(joint_rare(p, peak_force, i) * p->step.inv_h);
	event.torque = finite_or_most(joint_rare(p, peak_torque, i) * p->step.inv_h);
	event.broken = (p->joint_flags[slot] & JOINT_CAN_BREAK) != 0;
	if (!(event.force > data->most_force || event.torque > data->most_torque))
		return;
	p->joint_event[atomic_add_int(&p->counters->joint_events, 1)] = event;
	if (!event.broken)
		return;
	p->joint_flags[slot] |= JOINT_BROKEN;
	if (p->step.sleep)
	{
		body_restless(p, data->body_a);
		body_restless(p, data->body_b);
	}
	raise_int(&p->counters->joints_dirty, 0x7fffffff);
}

#endif
