// SPDX-License-Identifier: MIT
// targets.c -- where kinematic bodies are to be at the end of the next step: set by the user, kept, sent with the step.
#include "world/targets.h"
#include "world/world.h"

static scree_status check_target(const scree_world* world, Where body, Where value, scree_body handle, scree_pose* pose)
{
	static const char* const types[] = {"static", "kinematic", "dynamic"};
	int index = 0;
	TRY(check_body(world, body, "", handle, &index));
	scree_body_type type = world->host_bodies[index].type;
	if (type != SCREE_BODY_KINEMATIC)
		return refuse(SCREE_ERROR_INVALID, body, "", "is %s: only a kinematic body has a target", types[type]);
	return check_pose(value, "", pose);
}

static scree_status set(scree_world* world, Where body, Where value, const scree_body* bodies, const scree_pose* poses,
                        int count)
{
	const char* function = body.function;
	bool alone = body.index == ALONE;
	TRY(world_check(world, function));
	TRY(check_batch(function, body.argument, bodies, count));
	TRY(check_batch(function, value.argument, poses, count));
	for (int k = 0; k < count; ++k)
	{
		scree_pose pose = poses[k];
		body.index = value.index = alone ? ALONE : k;
		TRY(check_target(world, body, value, bodies[k], &pose));
	}
	TRY(GROW(function, world->targets, world->target_capacity, world->target_count + count));
	TRY(edits_reserve(world, function, 0, 0, count));
	for (int k = 0; k < count; ++k)
	{
		Target target = {(int)bodies[k].index, poses[k]};
		check_pose(value, "", &target.pose); // takes rounding out
		HostBody* host = world->host_bodies + target.body;
		if (host->target == 0)
		{
			host->target = ++world->target_count;
			edits_command(world, COMMAND_VELOCITY, target.body, make_float4(0.0f, 0.0f, 0.0f, 0.0f), 0);
		}
		world->targets[host->target - 1] = target;
	}
	return SCREE_OK;
}

scree_status scree_bodies_set_targets(scree_world* world, const scree_body* bodies, const scree_pose* poses, int count)
{
	const char* function = "scree_bodies_set_targets";
	return set(world, (Where){function, "bodies", 0}, (Where){function, "poses", 0}, bodies, poses, count);
}

scree_status scree_body_set_target(scree_world* world, scree_body body, scree_pose pose)
{
	const char* function = "scree_body_set_target";
	return set(world, (Where){function, "body", ALONE}, (Where){function, "pose", ALONE}, &body, &pose, 1);
}

// The last target takes the place of this one.
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

// ---------------------------------------------------------------------------------------------------------------
// the step
// ---------------------------------------------------------------------------------------------------------------

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
		begin[sent].value = make_float4(pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s);
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
		if (takes_part(world, world->targets + k))
			target_drop(world, world->targets[k].body);
}
