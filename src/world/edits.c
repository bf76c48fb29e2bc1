// SPDX-License-Identifier: MIT
// edits.c -- records the user's changes until the next upload.
#include "world/edits.h"
#include "platform/error.h"
#include "world/memory.h"
#include "world/pool_values.h"
#include "world/world.h"

scree_status edits_reserve(scree_world* world, const char* function, int bodies, int collidables, int commands)
{
	Edits* p = &world->edits;
	TRY(GROW(function, p->bodies, p->body_capacity, p->body_count + bodies));
	TRY(GROW(function, p->collidables, p->collidable_capacity, p->collidable_count + collidables));
	// each new or removed collidable needs 2 commands, for a link of its list and a ContinuousBody; mass_settle needs 1
	return GROW(function, p->commands, p->command_capacity, p->command_count + commands + 2 * collidables + 1);
}

void edits_close(Edits* edits)
{
	scree_release(edits->bodies);
	scree_release(edits->collidables);
	scree_release(edits->commands);
	scree_release(edits->attributes);
	scree_release(edits->joints);
	scree_release(edits->paths);
}

bool edits_heavy(float inv_mass, float inv_inertia)
{
	const float least = 1.0f / HEAVY_MASS;
	return (inv_mass > 0.0f && inv_mass < least) || (inv_inertia > 0.0f && inv_inertia < least);
}

static void note_heavy(scree_world* world, float inv_mass, float inv_inertia)
{
	world->pipeline.heavy |= edits_heavy(inv_mass, inv_inertia);
}

void edits_body(scree_world* world, BodyRow row)
{
	Edits* p = &world->edits;
	PendingEdits* waiting = &world->host_bodies[row.index].waiting;
	if (waiting->row == 0)
		waiting->row = ++p->body_count;
	note_heavy(world, row.inv_mass, row.inv_inertia);
	BodyRow* to = &p->bodies[waiting->row - 1];
	*to = row;
	to->since = p->command_count;
	// all numbers but the inverses, which may be tiny; from `row`, because the processor stores *to in other parts
	flush_copy(&to->pose.position.x, &row.pose.position.x, (int)(&row.inv_mass - &row.pose.position.x));
}

void edits_collidable(scree_world* world, int index)
{
	Edits* p = &world->edits;
	PendingEdits* waiting = &world->host_collidables[index].waiting;
	if (waiting->row == 0)
		waiting->row = ++p->collidable_count;
	p->collidables[waiting->row - 1] = (CollidableRow){index, p->command_count};
}

int command_bits(const scree_world* world, int body)
{
	const HostBody* host = world->host_bodies + body;
	bool joined = host->type != SCREE_BODY_DYNAMIC && (host->first_joint > 0 || host->fields > 0);
	return (host->disabled ? COMMAND_DISABLED : 0) | (joined ? COMMAND_JOINED : 0);
}

void edits_command(scree_world* world, int kind, int index, Float4 value, int whole)
{
	edits_whole(world, (Command){.kind = kind, .index = index, .whole = {whole}, .value = value});
}

void edits_whole(scree_world* world, Command command)
{
	Edits* p = &world->edits;
	if (command.kind < COMMAND_BODY)
		command.whole[1] = command_bits(world, command.index);
	if (command.kind == COMMAND_MASS)
	{
		note_heavy(world, command.value.x, command.value.y);
		flush_row(&command.value.z, 2); // inverse masses may be tiny
	}
	else
		flush_row(&command.value.x, 4);
	p->commands[p->command_count++] = command;
}
