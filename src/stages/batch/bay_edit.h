// SPDX-License-Identifier: MIT
// bay_edit.h -- changes masses, surfaces, disabled bodies and joints of single worlds of a batch, as the user's calls do to a
// world alone.
#ifndef BAY_EDIT_H
#define BAY_EDIT_H
#include "pools/bays.h"
#include "stages/color/joint_edges.h"
#include "stages/edit/command.h"

// Gives a collidable another attribute of the same shape. Queries may come before the next step, which sets its world_shape.
INLINE void bay_share(const Pools* p, int collidable, int attribute)
{
	p->collidable_attribute[collidable] = attribute;
	p->world_shape[collidable].attribute = attribute;
	p->collidable_flags[collidable] |= COLLIDABLE_CHANGED;
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

// Item: a world with changes, whose commands are adjacent.
KERNEL(bay_edit)
{
	for (int k = p->command_group[i]; k < p->command_group[i + 1]; ++k)
	{
		Command c = p->command[k];
		int kept = JOINT_BROKEN | JOINT_RESTARTS | JOINT_NEW | JOINT_ASLEEP;
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
			p->joint_flags[c.index] = c.whole[0] | (p->joint_flags[c.index] & kept);
			raise_int(&p->counters->joints_dirty, 0x7fffffff);
			break;
		case COMMAND_ORIGIN:
			p->bay[c.index].attribute = c.whole[0];
			p->bay_state[c.index].surfaces |= c.whole[1];
			break;
		default:
			command_apply(p, c);
		}
	}
}

#endif
