// SPDX-License-Identifier: MIT
// channel_angles.h -- writes angles and speeds of joints of several worlds of a batch at once.
//
// The operations are those of channel_angle in channel_output.h, in the same order, so the bits are equal.
#ifndef CHANNEL_ANGLES_H
#define CHANNEL_ANGLES_H
#include "constraints/joint_prepare.h"
#include "pools/bays.h"
#include "pools/channel_types.h"

// Returns the last angles of joints, as joint_turned_last.
INLINE Real channel_angles_last(const Pools* p, Int slot)
{
	Int place = gather_int(p->joint_place, slot), flags = gather_int(p->joint_flags, slot);
	Int c = place & ~(place >> 31), block = c / MAX_LANES;
	Int at = block * (int)(sizeof(JointRows) / sizeof(float)) + (c - block * MAX_LANES);
	Real row = gather((const GLOBAL float*)p->joint_rows->turned, at);
	Real kept = gather(&p->joint_kept->turned, slot * (int)(sizeof(JointKept) / sizeof(float)));
	return only(blend(row, kept, place < 0), (flags & (int)JOINT_NEW) == 0);
}

// Returns the rotation of a frame of joints in the world, as channel_frame. side: 0 or 1; body: bodies of this side.
INLINE JointFrame channel_frames(const Pools* p, Int slot, int side, Int body)
{
	Real frame[4], pose[4];
	JointFrame at;
	gather_rows4((GLOBAL float*)p->joint_data, slot * JOINT_QUADS + JOINT_AT_FRAME(side), frame);
	gather_rows4((GLOBAL float*)p->pose, body, pose);
	at.turn = vec_turn(vec(pose[2], pose[3]), vec(frame[2], frame[3]));
	at.arm = at.position = at.rest = vec(splat(0.0f), splat(0.0f));
	return at;
}

// Item: LANES worlds of a group of outputs, all angles of one joint or speeds of this angle. All worlds have the same
// template. argument: RUN_PAIR(list, rows); the rows of each group are padded to a multiple of MAX_LANES.
WIDE_KERNEL(channel_angles)
{
	int rows = RUN_HIGH(p->argument), padded = (rows + MAX_LANES - 1) / MAX_LANES * MAX_LANES;
	int group = i / padded, n = i - group * padded, bits = p->step.bays.joint_bits;
	ChannelList list = p->channel_list[RUN_LOW(p->argument) & CHANNEL_LIST];
	const GLOBAL int* first = p->channel_group + list.first_group + group;
	const GLOBAL Channel* channels = p->channel + list.first + p->bay->number * list.channels;
	Int bay = indices(n), last = 0 * bay + (rows - 1);
	bay = blend_int(bay, last, bay > last);
	Int slot = (bay << bits) + channels[first[0]].item, data = slot * (int)(sizeof(JointData) / sizeof(int));
	Int ia = gather_int((const GLOBAL int*)p->joint_data, data),
	    ib = gather_int((const GLOBAL int*)p->joint_data, data + 1);
	JointFrame a = channel_frames(p, slot, 0, ia), b = channel_frames(p, slot, 1, ib);
	Real value = flush_tiny(joint_turned(&a, &b, channel_angles_last(p, slot)));
	Real speed = flush_tiny(number_of(gather(&p->body->w, 8 * ib) - gather(&p->body->w, 8 * ia)));
	Int row = gather_int(&p->bay->world, bay * (int)(sizeof(Bay) / sizeof(int))) * list.columns + list.column;
	for (int k = first[0]; k < first[1]; ++k)
	{
		Real out = channels[k].kind == CHANNEL_GET_JOINT_VALUE ? value : speed;
		for (int j = 0; j < LANES && n + j < rows; ++j)
			p->column[lane(row, j) + channels[k].column] = lane(out, j);
	}
}

#endif
