// SPDX-License-Identifier: MIT
// batch_drive.h -- drives the worlds of a batch that is measured: random resets and inputs before each step, outputs after it.
//
// Resets and inputs depend on the number of a world among all worlds, so a part of them has the bits that it has in one batch.
#ifndef BATCH_DRIVE_H
#define BATCH_DRIVE_H
#include "cli/common/options.h"
#include "scene/wall_inputs.h"

typedef struct
{
	const Options* options;
	int first, worlds;  // number of the first world of this batch among Options.worlds; number of its worlds
	int columns;        // columns of the outputs
	int most;           // number of worlds of the largest share
	int ready;          // number of steps whose resets and inputs are prepared at once, the same for all shares
	WallInputs random;  // inputs that are bound
	uint8_t* masks;     // [ready][worlds]: worlds that are reset before a step; null without resets
	float* inputs;      // [ready][worlds][random.count]; null without inputs
	scree_batch* batch; // not owned
} BatchDrive;

// Returns share k of `shares` of the part of the worlds that the options select; Options.parts is at least 1.
BatchDrive batch_drive_make(const Options* options, int k, int shares);

// Returns whether a world, a number among all worlds, is never reset and keeps the inputs of the scene: the first and the last one.
static inline bool batch_drive_keeps(const BatchDrive* drive, int64_t world)
{
	return world == 0 || world == drive->options->worlds - 1;
}

// Binds inputs and outputs to objects of the template, and makes room for `steps` steps. Writes a sentence (SCENE_SENTENCE
// characters) and returns false on failure. The caller closes the drive also on failure.
bool batch_drive_bind(BatchDrive* drive, scree_batch* batch, scree_world* world, int steps, char* sentence);
void batch_drive_close(BatchDrive* drive); // the share and the number of columns stay

// Prepares the steps from `step` on, if it is the first of `ready` ones.
void batch_drive_prepare(BatchDrive* drive, int step);

// Resets worlds and sets inputs, as prepared for this step. Then takes the step.
scree_status batch_drive_step(BatchDrive* drive, int step, float dt, int substeps);

#endif
