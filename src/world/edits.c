// SPDX-License-Identifier: MIT
// edits.c -- what the user changed, kept until the device is told.
#include "world/edits.h"
#include "world/world.h"

scree_status pending_reserve(scree_world* world, const char* function, int bodies, int collidables, int commands)
{
	Pending* p = &world->pending;
	TRY(GROW(function, p->bodies, p->body_capacity, p->body_count + bodies));
	TRY(GROW(function, p->collidables, p->collidable_capacity, p->collidable_count + collidables));
	// a collidable that comes or goes changes a link of its body's list, and what guard knows of the body
	return GROW(function, p->commands, p->command_capacity, p->command_count + commands + 2 * collidables);
}

void pending_close(Pending* pending)
{
	scree_release(pending->bodies);
	scree_release(pending->collidables);
	scree_release(pending->commands);
	scree_release(pending->attributes);
}

void pending_body(scree_world* world, BodyRow row)
{
	Pending* p = &world->pending;
	Waiting* waiting = &world->host_bodies[row.index].waiting;
	if (waiting->row == 0)
		waiting->row = ++p->body_count;
	row.since = p->command_count;
	p->bodies[waiting->row - 1] = row;
}

void pending_collidable(scree_world* world, int index)
{
	Pending* p = &world->pending;
	Waiting* waiting = &world->host_collidables[index].waiting;
	if (waiting->row == 0)
		waiting->row = ++p->collidable_count;
	p->collidables[waiting->row - 1] = (CollidableRow){index, p->command_count};
}

void pending_command(scree_world* world, int kind, int index, Float4 value, int whole)
{
	pending_whole(world, (Command){.kind = kind, .index = index, .whole = {whole}, .value = value});
}

void pending_whole(scree_world* world, Command command)
{
	Pending* p = &world->pending;
	if (command.kind < COMMAND_BODY)
		command.whole[1] = world->host_bodies[command.index].disabled;
	p->commands[p->command_count++] = command;
}
