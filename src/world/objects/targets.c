// SPDX-License-Identifier: MIT
// targets.c -- keeps the targets of kinematic bodies: poses at the end of the next step with dt above 0.
#include "world/objects/targets.h"
#include "platform/error.h"
#include "world/edits.h"
#include "world/memory.h"
#include "world/pool_values.h"
#include "world/world.h"

scree_status targets_reserve(scree_world* world, const char* function, int more)
{
	TRY(GROW(function, world->targets, world->target_capacity, world->target_count + more));
	return edits_reserve(world, function, 0, 0, more);
}

void target_put(scree_world* world, int body, scree_pose pose)
{
	HostBody* host = world->host_bodies + body;
	if (host->target == 0)
	{
		host->target = ++world->target_count;
		edits_command(world, COMMAND_VELOCITY, body, make_float4(0.0f, 0.0f, 0.0f, 0.0f), 0);
	}
	world->targets[host->target - 1] = (Target){body, pose};
}

void target_drop(scree_world* world, int body)
{
	HostBody* host = world->host_bodies + body;
	if (host->target == 0)
		return;
	Target last = world->targets[--world->target_count];
	world->targets[host->target - 1] = last;
	world->host_bodies[last.body].target = host->target;
	host->target = 0;
}

static bool takes_part(const scree_world* world, const Target* target)
{
	return !world->host_bodies[target->body].disabled;
}

static int sent_count(const scree_world* world)
{
	int count = 0;
	for (int k = 0; k < world->target_count; ++k)
		count += takes_part(world, world->targets + k);
	return count;
}

scree_status targets_commands(scree_world* world, StepCommands* commands)
{
	int count = sent_count(world), sent = 0;
	*commands = (StepCommands){.count = count};
	if (count == 0)
		return SCREE_OK;
	Command* begin = world_scratch(world, (size_t)count * (3 * sizeof *begin + sizeof(int)) + sizeof(int));
	if (!begin)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "scree_world_step: no memory for %d targets", count);
	Command *end = begin + count, *undo = end + count;
	int* groups = (int*)(undo + count);
	for (int k = 0; k < world->target_count; ++k)
	{
		const Target* target = world->targets + k;
		scree_pose pose = target->pose;
		if (!takes_part(world, target))
			continue;
		begin[sent] = (Command){.kind = COMMAND_TARGET, .index = target->body};
		begin[sent].whole[0] = (int)world->host_bodies[target->body].locks;
		begin[sent].whole[1] = command_bits(world, target->body);
		begin[sent].value = pose_row(pose);
		end[sent] = begin[sent];
		end[sent].kind = COMMAND_ARRIVE;
		undo[sent] = (Command){.kind = COMMAND_VELOCITY, .index = target->body};
		groups[sent] = sent;
		++sent;
	}
	groups[sent] = sent;
	commands->begin = begin;
	commands->end = end;
	commands->undo = undo;
	commands->groups = groups;
	return SCREE_OK;
}

void targets_arrived(scree_world* world)
{
	for (int k = world->target_count - 1; k >= 0; --k)
	{
		Target target = world->targets[k];
		HostBody* host = world->host_bodies + target.body;
		if (!takes_part(world, &target))
			continue;
		host->from = host->stands;
		host->went = host->still ? world->pipeline.steps : -1;
		host->stands = target.pose;
		host->still = host->locks == 0;
		target_drop(world, target.body);
	}
}
