// SPDX-License-Identifier: MIT
// channel_input.h -- applies rows of inputs to the worlds of a batch, as the user's calls do to a world alone.
#ifndef CHANNEL_INPUT_H
#define CHANNEL_INPUT_H
#include "pools/bays.h"
#include "stages/color/joint_edges.h"
#include "stages/edit/active.h"
#include "stages/edit/command.h"
#include "stages/read/moved_bodies.h"

typedef struct // a group of channels in a bay: all channels of one object, in the order of the list
{
	const GLOBAL Channel* channels; // those of the template of the world
	int bay, first, end;
	GLOBAL float* row;
} ChannelGroup;

// Returns the group and the bay of item i: number of the row * groups + number of the group, so that work-items next to each other
// read values of one world, and write to one row. argument: RUN_PAIR(list | CHANNEL_* bits, CHANNEL_GROUPS). Inputs of a reset have a
// row for each copy, other lists one for each world.
INLINE ChannelGroup channel_group(const Pools* p, int i)
{
	int groups = RUN_HIGH(p->argument) / CHANNEL_FIRST, first = RUN_HIGH(p->argument) % CHANNEL_FIRST;
	int n = i / groups, group = first + i - n * groups, low = RUN_LOW(p->argument);
	ChannelList list = p->channel_list[low & CHANNEL_LIST];
	ChannelGroup at;
	at.bay = low & CHANNEL_COPIES ? p->bay_copy[n].y : n;
	Bay bay = p->bay[at.bay];
	at.channels = p->channel + list.first + bay.number * list.channels;
	at.first = p->channel_group[list.first_group + group];
	at.end = p->channel_group[list.first_group + group + 1];
	at.row = p->column + list.column + ((low & CHANNEL_LIST) == CHANNELS_RESET ? n : bay.world) * list.columns;
	return at;
}

// Returns a point of a body's frame in the world, with the same rounding as scree_body_get_world_point.
INLINE Vec channel_point(Float4 origin, float x, float y)
{
	return vec_add(vec(origin.x, origin.y), vec_turn(vec(origin.z, origin.w), vec(x, y)));
}

// Requests a search of the whole path for all joints of a body on paths, because the body was placed. Then channel_stir stirs their
// bodies.
INLINE void channel_seek(const Pools* p, int bay, int body)
{
	int bits = p->step.bays.joint_bits;
	for (int slot = bay << bits; slot < (bay + 1) << bits; ++slot)
	{
		const GLOBAL JointData* data = p->joint_data + slot;
		if (p->joint_flags[slot] & JOINT_THERE && (int)data->modes & JOINT_RAILED &&
		    (data->body_a == body || data->body_b == body))
		{
			joint_seek(p, slot);
			if (p->step.sleep)
				p->joint_flags[slot] |= JOINT_STIRS;
		}
	}
}

// Returns the bits with which a world alone marks a command of a body.
INLINE int channel_bits(const Pools* p, int body)
{
	return p->stored_velocity[body].stored != 0.0f ? COMMAND_DISABLED : 0;
}

// Returns the command that an input of a body is.
INLINE Command channel_command(const Pools* p, const GLOBAL Channel* c, int body, const GLOBAL float* v)
{
	Command command;
	Float4 origin;
	Vec force, at;
	command.kind = COMMAND_FORCE;
	command.index = body;
	command.whole[0] = c->locks;
	command.whole[1] = c->bits | channel_bits(p, body);
	command.value = make_float4(v[0], 0.0f, 0.0f, 0.0f);
	switch (c->kind)
	{
	case CHANNEL_SET_THRUST:
		origin = reported_origin(p, body);
		force = vec_turn(vec(origin.z, origin.w), vec(v[0], v[1]));
		at = channel_point(origin, c->place.x, c->place.y);
		command.kind = COMMAND_FORCE_AT;
		command.value = make_float4(force.x, force.y, at.x, at.y);
		break;
	case CHANNEL_SET_TORQUE:
		command.kind = COMMAND_TORQUE;
		break;
	case CHANNEL_SET_ANGULAR_IMPULSE:
		command.kind = COMMAND_ANGULAR_IMPULSE;
		break;
	case CHANNEL_SET_IMPULSE:
		command.kind = COMMAND_IMPULSE;
		command.value.y = v[1];
		break;
	case CHANNEL_SET_VELOCITY:
		command.kind = COMMAND_VELOCITY;
		command.value =
		    make_float4(c->locks & 1 ? 0.0f : v[0], c->locks & 2 ? 0.0f : v[1], c->locks & 4 ? 0.0f : v[2], 0.0f);
		break;
	case CHANNEL_SET_POSE:
	case CHANNEL_SET_TARGET:
		command.kind = c->kind == CHANNEL_SET_POSE ? COMMAND_POSE : COMMAND_TARGET;
		command.value = make_float4(v[0], v[1], v[2], v[3]);
		break;
	default:
		command.value.y = v[1];
	}
	command.value = make_float4(flush_tiny(command.value.x), flush_tiny(command.value.y), flush_tiny(command.value.z),
	                            flush_tiny(command.value.w));
	return command;
}

INLINE void channel_joint_set(const Pools* p, const GLOBAL Channel* c, int slot, float value)
{
	GLOBAL JointData* data = p->joint_data + slot;
	GLOBAL float* to = c->kind == CHANNEL_SET_MOTOR_SPEED ? &data->drive[c->which].speed
	                   : c->kind == CHANNEL_SET_MOTOR_MAX ? &data->drive[c->which].motor_most
	                                                      : &data->lock[c->which].target;
	if (c->kind == CHANNEL_SET_JOINT_TARGET)
		value = minimum(maximum(value, c->lower), c->upper);
	value = flush_tiny(value);
	if (p->step.sleep && float_bits(*to) != float_bits(value))
		p->joint_flags[slot] |= JOINT_STIRS;
	*to = value;
}

// Applies a command to a body. In a step with sleep, ends the rest of the groups of an awake body: alone, a world collects
// these groups on the host (world/device/touched.c).
INLINE void channel_apply(const Pools* p, Command command)
{
	int body = command.index, rests = !(p->body[body].inv_mass > 0.0f) || p->sleep[body] != 0;
	command_apply(p, command);
	if (!p->step.sleep || p->sleep[body] != 0)
		return;
	active_touch_body(p, body);
	if (rests || command.kind == COMMAND_POSE)
		raise_int(&p->counters->touched, 0x7fffffff);
}

// Returns whether forces and torques act, which steps need again: other inputs stay in the state of the world.
INLINE int channel_acts(int kind)
{
	return kind == CHANNEL_SET_FORCE || kind == CHANNEL_SET_THRUST || kind == CHANNEL_SET_TORQUE;
}

// Returns whether an input acts in the part of a step that the argument names.
INLINE int channel_takes_part(const Pools* p, const GLOBAL Channel* c, int body)
{
	int low = RUN_LOW(p->argument);
	if (c->kind == CHANNEL_KINDS)
		return 0;
	if (low & CHANNEL_AGAIN)
		return channel_acts(c->kind);
	if (c->kind != CHANNEL_SET_TARGET)
		return !(low & (CHANNEL_AIMS | CHANNEL_ARRIVES));
	return low & (CHANNEL_AIMS | CHANNEL_ARRIVES) && p->stored_velocity[body].stored == 0.0f;
}

// Item: a group of inputs of a world. argument: as in channel_group.
KERNEL(channel_input)
{
	ChannelGroup at = channel_group(p, i);
	for (int k = at.first; k < at.end; ++k)
	{
		const GLOBAL Channel* c = at.channels + k;
		const GLOBAL float* values = at.row + c->column;
		if (c->kind >= CHANNEL_SET_MOTOR_SPEED)
		{
			if (channel_takes_part(p, c, 0))
				channel_joint_set(p, c, (at.bay << p->step.bays.joint_bits) + c->item, values[0]);
			continue;
		}
		int body = at.bay * p->step.bays.bodies + c->item;
		if (!channel_takes_part(p, c, body))
			continue;
		Command command = channel_command(p, c, body, values);
		if (RUN_LOW(p->argument) & CHANNEL_ARRIVES)
			command.kind = COMMAND_ARRIVE;
		if (RUN_LOW(p->argument) & CHANNEL_ARRIVES && RUN_LOW(p->argument) & CHANNEL_AIMS)
		{
			command.kind = COMMAND_VELOCITY;
			command.value = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
		}
		channel_apply(p, command);
		if (command.kind == COMMAND_POSE && p->step.paths)
			channel_seek(p, at.bay, body);
	}
}

// Item: a value of a list of inputs in shared memory, which the host cannot check. argument: number of the list.
KERNEL(channel_check)
{
	GLOBAL ChannelList* list = p->channel_list + p->argument;
	int columns = list->columns, values = p->step.bays.worlds * columns, column = i % columns;
	const GLOBAL float* least = p->column + list->bounds;
	float value = p->column[list->column + i];
	if (!(value >= least[column]) || !(value <= least[columns + column]))
		raise_int(&list->wrong, values - i);
}

// Wakes a body whose joint was changed, as a call of the user does.
INLINE void channel_stir_body(const Pools* p, int body)
{
	Command command;
	if (!(p->body[body].inv_mass > 0.0f))
		return;
	command.kind = COMMAND_JOINTS;
	command.index = body;
	command.whole[0] = 0;
	command.whole[1] = channel_bits(p, body);
	command.value = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	channel_apply(p, command);
}

// Item: a row of inputs, in a step with sleep. Wakes the bodies of the joints that inputs changed. One item has all joints of
// a world, because joints share bodies. argument: as in channel_group.
KERNEL(channel_stir)
{
	int bits = p->step.bays.joint_bits, bay = RUN_LOW(p->argument) & CHANNEL_COPIES ? p->bay_copy[i].y : i;
	for (int slot = bay << bits; slot < (bay + 1) << bits; ++slot)
	{
		int flags = p->joint_flags[slot];
		if (!(flags & JOINT_STIRS))
			continue;
		p->joint_flags[slot] = flags & ~JOINT_STIRS;
		if (p->bay[bay].sleep_threshold < 0.0f)
			continue;
		channel_stir_body(p, p->joint_data[slot].body_a);
		channel_stir_body(p, p->joint_data[slot].body_b);
	}
}

#endif
