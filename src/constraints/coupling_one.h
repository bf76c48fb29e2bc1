// SPDX-License-Identifier: MIT
// coupling_one.h -- computes the coordinate of a gear or a pulley, for one joint at a time.
//
// Angles include all full turns, and a float rounds large angles coarsely. Therefore each step adds only the change of
// the angles to the stored coordinate. This also lets the user change the ratio of a turning gear without a jump.
#ifndef COUPLING_ONE_H
#define COUPLING_ONE_H
#include "constraints/joint_prepare.h"

#define TURN_REST (-1.7484556e-7f) // 2 pi - TURN

typedef struct // counts of a coupling, updated at the start of each step
{
	float angle[2], turns[2]; // last angles of bodies a and b, rad; their numbers of full turns
	float geared;             // rad: contribution of the angles to the coordinate
} CouplingCount;

typedef struct // one side of a coupling, in the frame of the world
{
	Vec line;           // for a distance, vector from base to anchor, m; for a translation, x axis of the base; else 0
	Vec arm;            // m: vector from the center of mass to the anchor
	float value, added; // m or rad: measure; rad: change of an angle since the last count, 0 for other measures
} CouplingMeasure;

INLINE CouplingCount coupling_count_new(const Pools* p, int slot)
{
	const GLOBAL JointData* data = p->joint_data + slot;
	int modes = (int)data->modes;
	float a = modes & JOINT_LINEAR(0) ? 0.0f : data->near[0];
	float b = modes & JOINT_LINEAR(1) ? 0.0f : data->near[1];
	CouplingCount count = {{a, b}, {0.0f, 0.0f}, b + data->gear_ratio * a};
	return count;
}

INLINE CouplingCount coupling_count_at(const Pools* p, int place)
{
	CouplingCount count = {{joint_rare(p, angle_a, place), joint_rare(p, angle_b, place)},
	                       {joint_rare(p, turns_a, place), joint_rare(p, turns_b, place)},
	                       joint_rare(p, geared, place)};
	return count;
}

INLINE void coupling_count_put(const Pools* p, int place, const CouplingCount* count)
{
	joint_rare(p, angle_a, place) = count->angle[0];
	joint_rare(p, angle_b, place) = count->angle[1];
	joint_rare(p, turns_a, place) = count->turns[0];
	joint_rare(p, turns_b, place) = count->turns[1];
	joint_rare(p, geared, place) = count->geared;
}

INLINE CouplingMeasure coupling_measure(const Pools* p, int slot, int side, CouplingCount* count)
{
	const GLOBAL JointData* data = p->joint_data + slot;
	int modes = (int)data->modes;
	JointFrame frame = joint_frame(p, slot, JOINT_AT_FRAME(side), side ? data->body_b : data->body_a, vec(0.0f, 0.0f));
	JointFrame base = joint_frame(p, slot, JOINT_AT_BASE(side), 0, vec(0.0f, 0.0f));
	Vec d = joint_gap(&base, &frame);
	CouplingMeasure m = {vec(0.0f, 0.0f), frame.arm, 0.0f, 0.0f};
	if (modes & JOINT_HOISTS(side))
	{
		m.line = d;
		m.value = root(vec_dot(d, d));
		return m;
	}
	if (modes & JOINT_SLIDES(side))
	{
		m.line = base.turn;
		m.value = vec_dot(d, m.line);
		return m;
	}
	float angle = vec_angle(vec_turn_back(base.turn, frame.turn)), last = count->angle[side];
	float turns = joint_round((last - angle) * (1.0f / TURN));
	m.added = ((angle - last) + TURN * turns) + TURN_REST * turns;
	count->angle[side] = angle;
	count->turns[side] = count->turns[side] + turns;
	m.value = angle + TURN * count->turns[side];
	return m;
}

typedef struct // both sides of a coupling, and its coordinate
{
	CouplingMeasure sides[2];
	float value; // m or rad: value of the coordinate, without the distances of pulleys
} CouplingState;

INLINE CouplingState coupling_state(const Pools* p, int slot, CouplingCount* count)
{
	const GLOBAL JointData* data = p->joint_data + slot;
	int modes = (int)data->modes;
	CouplingState now;
	now.sides[0] = coupling_measure(p, slot, 0, count);
	now.sides[1] = coupling_measure(p, slot, 1, count);
	count->geared = count->geared + (now.sides[1].added + data->gear_ratio * now.sides[0].added);
	float a = modes & JOINT_SLIDES(0) ? now.sides[0].value : 0.0f,
	      b = modes & JOINT_SLIDES(1) ? now.sides[1].value : 0.0f;
	now.value = count->geared + (b + data->gear_ratio * a);
	return now;
}

// Writes the rows of joint i, a coupling, for the step.
INLINE void coupling_setup(const Pools* p, int i)
{
	int slot = p->joint_place_slot[i];
	CouplingCount count = coupling_count_at(p, i);
	CouplingState now = coupling_state(p, slot, &count);
	joint_rare(p, gear_ratio, i) = p->joint_data[slot].gear_ratio;
	joint_rare(p, coupled, i) = now.value;
	joint_rare(p, line_a_x, i) = now.sides[0].line.x;
	joint_rare(p, line_a_y, i) = now.sides[0].line.y;
	joint_rare(p, line_b_x, i) = now.sides[1].line.x;
	joint_rare(p, line_b_y, i) = now.sides[1].line.y;
	coupling_count_put(p, i, &count);
	joint_rare(p, given_a_x, i) = 0.0f;
	joint_rare(p, given_a_y, i) = 0.0f;
}

#endif
