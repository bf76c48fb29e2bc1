// SPDX-License-Identifier: MIT
// bay_edit.h -- changes masses, surfaces, disabled bodies and joints of single worlds of a batch, as the user's calls do to a
// world alone.
#ifndef BAY_EDIT_H
#define BAY_EDIT_H
#include "pools/bays.h"
#include "stages/batch/channel_input.h"

// Sets the place of the attribute of a collidable, also in its world_shape, because queries may come before the next step.
INLINE void bay_share(const Pools* p, int collidable, int attribute)
{
	p->collidable_attribute[collidable] = attribute;
	p->world_shape[collidable].attribute = attribute;
}

// Writes an attribute with the shape of another one.
INLINE void bay_surface(const Pools* p, int to, int shape, Float4 surface)
{
	GLOBAL Attribute* attribute = p->attribute + to;
	*attribute = p->attribute[shape];
	attribute->friction = surface.x;
	attribute->restitution = surface.y;
	attribute->rolling_resistance = surface.z;
	attribute->tangent_speed = surface.w;
	p->thickness[to] = p->thickness[shape];
	p->rule[to] = p->rule[shape];
}

// Ends the rest of all groups of a world that sleeps. No step visits the groups of a spare bay.
INLINE void bay_touch(const Pools* p, int bay)
{
	const Bays* bays = &p->step.bays;
	if (bay >= bays->worlds)
		return;
	int body = bay * bays->bodies, collidable = bay * bays->collidables;
	for (int k = 0; k < bays->bodies; ++k)
		active_touch(p, GROUPS_OF_BODIES, body + k);
	for (int k = 0; k < bays->collidables; ++k)
		active_touch(p, GROUPS_OF_COLLIDABLES, collidable + k);
	raise_int(&p->counters->touched, 0x7fffffff); // contacts that may change
}

// Item: a world with changes, whose commands are adjacent.
KERNEL(bay_edit)
{
	for (int k = p->command_group[i]; k < p->command_group[i + 1]; ++k)
	{
		Command c = p->command[k];
		switch (c.kind)
		{
		case COMMAND_SURFACE:
			bay_surface(p, c.whole[0], c.whole[1], c.value);
			bay_share(p, c.index, c.whole[0]);
			break;
		case COMMAND_SHARE:
			bay_share(p, c.index, c.whole[0]);
			break;
		case COMMAND_JOINT: // as in joint_apply
			p->joint_flags[c.index] = c.whole[0] | (p->joint_flags[c.index] & JOINT_KEPT_BITS);
			raise_int(&p->counters->joints_dirty, 0x7fffffff);
			break;
		case COMMAND_ORIGIN:
			p->bay[c.index].attribute = c.whole[0];
			p->bay_state[c.index].surfaces |= c.whole[1];
			if (p->step.sleep)
				bay_touch(p, c.index);
			break;
		default:
			if (c.kind < COMMAND_PLACE)
				channel_apply(p, c);
			else
				command_apply(p, c);
		}
	}
}

#endif
