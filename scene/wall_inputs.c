// SPDX-License-Identifier: MIT
// wall_inputs.c -- random inputs of the worlds of a batch: speeds of motors or, without motors, pushes of bodies.
#include "scene/wall_inputs.h"
#include "scene/scene.h"
#include <math.h>
#include <scree/scree_math.h>
#include <stdio.h>
#include <stdlib.h>

#define SEED 1
#define HOLD 0.5f // s: time for which an input stays
#define TURN 2.0f // m/s or rad/s: range of a motor that stands still in the scene
#define PUSH 3.0f // m/s^2: largest acceleration by a push along each axis

typedef struct // channels while they are collected
{
	scree_channel* list;
	int count;
} Channels;

static void add_input(WallInputs* inputs, Channels* made, scree_channel channel, float middle, float range)
{
	int columns = channel.kind == SCREE_INPUT_FORCE ? 2 : 1;
	made->list[made->count++] = channel;
	for (int k = 0; k < columns; ++k, ++inputs->count)
	{
		inputs->middles[inputs->count] = middle;
		inputs->ranges[inputs->count] = range;
	}
}

// Collects the motors of the joints.
static scree_status add_motors(WallInputs* inputs, Channels* made, scree_world* world, const scree_joint* joints,
                               int count)
{
	scree_status status = SCREE_OK;
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		scree_joint_def def;
		status = scree_joint_get_def(world, joints[k], &def);
		for (int c = 0; c < 3 && status == SCREE_OK; ++c)
		{
			const scree_joint_coordinate* at = def.coordinates + c;
			scree_channel channel = scree_channel_make(SCREE_INPUT_MOTOR_SPEED);
			channel.joint = joints[k];
			channel.which = (scree_coordinate)c;
			if (at->motor && at->motor_max > 0.0f)
				add_input(inputs, made, channel, at->motor_speed,
				          at->motor_speed == 0.0f ? TURN : fabsf(at->motor_speed));
		}
	}
	return status;
}

// Collects a force for each dynamic body.
static scree_status add_pushes(WallInputs* inputs, Channels* made, scree_world* world, const scree_body* bodies,
                               int count)
{
	scree_status status = SCREE_OK;
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		scree_mass mass;
		scree_channel channel = scree_channel_make(SCREE_INPUT_FORCE);
		channel.body = bodies[k];
		status = scree_body_get_mass(world, bodies[k], &mass);
		if (status == SCREE_OK && mass.mass > 0.0f)
			add_input(inputs, made, channel, 0.0f, PUSH * mass.mass);
	}
	return status;
}

bool wall_inputs_bind(WallInputs* inputs, scree_batch* batch, scree_world* world, const scree_body* bodies, int count,
                      char* sentence)
{
	int joint_count = 0;
	scree_status status = scree_world_get_joints(world, NULL, 0, &joint_count);
	size_t most = 3 * (size_t)joint_count + 2 * (size_t)count + 1;
	scree_joint* joints = malloc(((size_t)joint_count + 1) * sizeof *joints);
	Channels made = {.list = malloc(most * sizeof *made.list)};
	inputs->middles = malloc(most * sizeof *inputs->middles);
	inputs->ranges = malloc(most * sizeof *inputs->ranges);
	bool memory = joints && made.list && inputs->middles && inputs->ranges;
	snprintf(sentence, SCENE_SENTENCE, "out of memory for the inputs of %d bodies", count);
	if (memory && status == SCREE_OK)
		status = scree_world_get_joints(world, joints, joint_count, &joint_count);
	if (memory && status == SCREE_OK)
		status = add_motors(inputs, &made, world, joints, joint_count);
	if (memory && status == SCREE_OK && made.count == 0)
		status = add_pushes(inputs, &made, world, bodies, count);
	if (memory && status == SCREE_OK)
		status = scree_batch_bind(batch, SCREE_STEP_INPUTS, made.list, made.count, NULL);
	if (memory && status != SCREE_OK)
		snprintf(sentence, SCENE_SENTENCE, "%s", scree_error());
	free(joints);
	free(made.list);
	return memory && status == SCREE_OK;
}

void wall_inputs_row(const WallInputs* inputs, uint64_t world, uint32_t draw, float* row)
{
	for (int k = 0; k < inputs->count; ++k)
	{
		scree_random drawn = scree_random_make(SEED, world, draw, (uint32_t)k);
		float by = scree_random_between(drawn.words[0], -inputs->ranges[k], inputs->ranges[k]);
		row[k] = world > 0 ? inputs->middles[k] + by : inputs->middles[k];
	}
}

void wall_inputs_draw(WallInputs* inputs, scree_batch* batch, int64_t steps, float dt)
{
	int every = (int)fmaxf(HOLD / dt, 1.0f), worlds = scree_batch_get_worlds(batch);
	float* row = scree_batch_get_rows(batch, SCREE_STEP_INPUTS);
	if (steps % every != 0 || !row)
		return;
	for (int world = 0; world < worlds; ++world, row += inputs->count)
		wall_inputs_row(inputs, (uint64_t)world, (uint32_t)(steps / every), row);
}

void wall_inputs_close(WallInputs* inputs)
{
	free(inputs->ranges);
	free(inputs->middles);
	*inputs = (WallInputs){0};
}

scree_status wall_sum(scree_batch* batch, uint64_t* sum)
{
	int worlds = scree_batch_get_worlds(batch);
	uint64_t* hashes = malloc(((size_t)worlds + 1) * sizeof *hashes);
	scree_status status = hashes ? scree_batch_get_hashes(batch, hashes) : SCREE_ERROR_OUT_OF_MEMORY;
	*sum = 0;
	for (int k = 0; k < worlds && status == SCREE_OK; ++k)
		*sum += hashes[k];
	free(hashes);
	return status;
}
