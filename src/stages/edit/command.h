// SPDX-License-Identifier: MIT
// command.h -- applies the user's commands since the last step, those of one item in the order of the calls.
#ifndef COMMAND_H
#define COMMAND_H
#include "stages/edit/command_body.h"
#include "stages/edit/command_stir.h"

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
		body_stand(p, i);
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
		if (c.whole[1] & COMMAND_JOINED)
			raise_int(&p->counters->woken, 0x7fffffff);
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
		if (BATCHED(p)) // only inputs that enable or disable a body make this command there
			p->collidable_flags[i] |= COLLIDABLE_RESTARTED;
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

INLINE void command_apply(const Pools* p, Command c)
{
	int bits = c.kind < COMMAND_BODY ? c.whole[1] : 0, disabled = bits & COMMAND_DISABLED;
	if (!(bits & COMMAND_NEW) && command_stirs(p, c))
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
