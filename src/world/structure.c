// SPDX-License-Identifier: MIT
// structure.c -- notes changes of the structure of a world: the data that only calls of the user change, never a step.
#include "world/structure.h"
#include "world/world.h"

void structure_changed(scree_world* world) { world->saves.version = ++world->saves.last; }

// Returns whether a command changes only data that steps change too.
static bool moves_only(const Command* command)
{
	switch (command->kind)
	{
	case COMMAND_FORCE:
	case COMMAND_FORCE_AT:
	case COMMAND_TORQUE:
	case COMMAND_IMPULSE:
	case COMMAND_IMPULSE_AT:
	case COMMAND_ANGULAR_IMPULSE:
	case COMMAND_VELOCITY:
	case COMMAND_LINEAR_VELOCITY:
	case COMMAND_SPIN:
		return !(command->whole[1] & COMMAND_DISABLED);
	case COMMAND_AWAKE:
		return true;
	default:
		return false;
	}
}

void structure_note(scree_world* world)
{
	const Edits* p = &world->edits;
	if (!world->saves.list) // nothing has been saved
		return;
	bool changed = world->fields.stale || world->materials.waiting || world->exclusions.waiting ||
	               p->body_count + p->collidable_count + p->attribute_count + p->joint_count + p->path_count > 0;
	for (int k = 0; k < p->command_count && !changed; ++k)
		changed = !moves_only(p->commands + k);
	if (changed)
		structure_changed(world);
}
