// SPDX-License-Identifier: MIT
// batch_drive.c -- drives the worlds of a batch that is measured: random resets and inputs before each step, outputs after it.
#include "batch_drive.h"
#include "platform/threads.h"
#include <scree/scree_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SEED           1                 // seed of the resets; another one gives other sums of hashes
#define PREPARED_BYTES ((size_t)1 << 28) // size of the resets and inputs that are prepared at once

BatchDrive batch_drive_make(const Options* options, int k, int shares)
{
	int begin = split(options->worlds, options->part - 1, options->parts);
	int worlds = split(options->worlds, options->part, options->parts) - begin;
	int first = split(worlds, k, shares), end = split(worlds, k + 1, shares);
	return (BatchDrive){
	    .options = options, .first = begin + first, .worlds = end - first, .most = (worlds + shares - 1) / shares};
}

// Binds poses and velocities of the bodies, in turns, with at most Options.columns columns.
static scree_status bind_outputs(BatchDrive* drive, scree_channel* list, const scree_body* bodies, int count)
{
	int channels = 0, columns = 0;
	for (int k = 0; k < 2 * count; ++k)
	{
		int width = k % 2 == 0 ? 4 : 3;
		if (columns + width > drive->options->columns)
			continue;
		list[channels] = scree_channel_make(k % 2 == 0 ? SCREE_OUTPUT_POSE : SCREE_OUTPUT_VELOCITY);
		list[channels++].body = bodies[k / 2];
		columns += width;
	}
	scree_status status = scree_batch_bind(drive->batch, SCREE_OUTPUTS, list, channels, NULL);
	drive->columns = scree_batch_get_columns(drive->batch, SCREE_OUTPUTS);
	return status;
}

static bool allocate(BatchDrive* drive, int steps, char* sentence)
{
	size_t worlds = (size_t)drive->worlds, inputs = (size_t)drive->random.count * sizeof *drive->inputs;
	size_t ready = PREPARED_BYTES / ((size_t)drive->most * (1 + inputs)) + 1;
	drive->ready = ready < (size_t)steps ? (int)ready : steps;
	if (drive->options->resets > 0.0f)
		drive->masks = malloc(worlds * (size_t)drive->ready);
	if (inputs > 0)
		drive->inputs = malloc(worlds * inputs * (size_t)drive->ready);
	snprintf(sentence, SCENE_SENTENCE, "out of memory for the inputs of %d worlds", drive->worlds);
	return (drive->masks || drive->options->resets == 0.0f) && (drive->inputs || inputs == 0);
}

bool batch_drive_bind(BatchDrive* drive, scree_batch* batch, scree_world* world, int steps, char* sentence)
{
	int count = 0;
	drive->batch = batch;
	scree_status status = scree_world_get_bodies(world, NULL, 0, &count);
	scree_body* bodies = malloc(((size_t)count + 1) * sizeof *bodies);
	scree_channel* list = malloc((2 * (size_t)count + 1) * sizeof *list);
	bool good = bodies && list;
	snprintf(sentence, SCENE_SENTENCE, "out of memory for the channels of %d bodies", count);
	if (good && status == SCREE_OK)
		status = scree_world_get_bodies(world, bodies, count, &count);
	if (good && status == SCREE_OK)
		status = bind_outputs(drive, list, bodies, count);
	if (good && status != SCREE_OK)
		snprintf(sentence, SCENE_SENTENCE, "%s", scree_error());
	good = good && status == SCREE_OK;
	if (good && drive->options->inputs)
		good = wall_inputs_bind(&drive->random, batch, world, bodies, count, sentence);
	free(bodies);
	free(list);
	return good && allocate(drive, steps, sentence);
}

void batch_drive_close(BatchDrive* drive)
{
	wall_inputs_close(&drive->random);
	free(drive->masks);
	free(drive->inputs);
	drive->masks = NULL;
	drive->inputs = NULL;
	drive->batch = NULL;
}

void batch_drive_prepare(BatchDrive* drive, int step)
{
	uint64_t limit = (uint64_t)((double)drive->options->resets / 100.0 * 4294967296.0);
	uint8_t* reset = drive->masks;
	float* row = drive->inputs;
	if (step % drive->ready != 0)
		return;
	for (int ahead = 0; ahead < drive->ready; ++ahead)
		for (int64_t world = drive->first; world < (int64_t)drive->first + drive->worlds; ++world)
		{
			uint64_t driven = batch_drive_keeps(drive, world) ? 0 : (uint64_t)world;
			uint32_t draw = (uint32_t)(step + ahead);
			if (reset)
				*reset++ = driven > 0 && scree_random_make(SEED, driven, draw, 0).words[0] < limit;
			if (row)
				wall_inputs_row(&drive->random, driven, draw, row);
			row = row ? row + drive->random.count : NULL;
		}
}

scree_status batch_drive_step(BatchDrive* drive, int step, float dt, int substeps)
{
	size_t ahead = (size_t)(step % drive->ready), worlds = (size_t)drive->worlds;
	size_t numbers = worlds * (size_t)drive->random.count;
	scree_status status = SCREE_OK;
	if (drive->masks)
		status = scree_batch_reset(drive->batch, drive->masks + ahead * worlds);
	if (drive->inputs)
		memcpy(scree_batch_get_rows(drive->batch, SCREE_STEP_INPUTS), drive->inputs + ahead * numbers,
		       numbers * sizeof *drive->inputs);
	return status == SCREE_OK ? scree_batch_step(drive->batch, dt, substeps, 1) : status;
}
