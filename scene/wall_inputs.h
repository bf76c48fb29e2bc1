// SPDX-License-Identifier: MIT
// wall_inputs.h -- random inputs of the worlds of a batch: speeds of motors or, without motors, pushes of bodies. The viewer, the
// page and scree hash show the same worlds by them.
#ifndef WALL_INPUTS_H
#define WALL_INPUTS_H
#include "scree/scree.h"
#include <stdbool.h>

typedef struct
{
	int count;      // number of columns
	float* middles; // middle of the range of each column: m/s, rad/s or N
	float* ranges;  // largest distance of each column from its middle
} WallInputs;

// Binds the inputs of a batch: the motors of a world or, if it has none, a force on each of `count` bodies. Writes a
// sentence (SCENE_SENTENCE characters) and returns false on failure. The caller closes the inputs also on failure.
bool wall_inputs_bind(WallInputs* inputs, scree_batch* batch, scree_world* world, const scree_body* bodies, int count,
                      char* sentence);
void wall_inputs_close(WallInputs* inputs);

// Writes the inputs of a world, count numbers: the middles for world 0, others by random numbers of the world and of `draw`.
void wall_inputs_row(const WallInputs* inputs, uint64_t world, uint32_t draw, float* row);

// Draws new inputs for all worlds if half a second has passed. steps: number of steps since the start, each of dt, s.
void wall_inputs_draw(WallInputs* inputs, scree_batch* batch, int64_t steps, float dt);

// Computes the sum of the hashes of all worlds, modulo 2^64.
scree_status wall_sum(scree_batch* batch, uint64_t* sum);

#endif
