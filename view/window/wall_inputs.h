// SPDX-License-Identifier: MIT
// wall_inputs.h -- random inputs of a wall of worlds: speeds of motors or, without motors, pushes of bodies.
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
// sentence (SENTENCE of shader.h) and returns false on failure. The caller closes the inputs also on failure.
bool wall_inputs_bind(WallInputs* inputs, scree_batch* batch, scree_world* world, const scree_body* bodies, int count,
                      char* sentence);
void wall_inputs_close(WallInputs* inputs);

// Draws new inputs for all worlds but the first if half a second has passed. The first world keeps the middles. steps:
// number of steps since the start, each of dt, s.
void wall_inputs_draw(WallInputs* inputs, scree_batch* batch, int64_t steps, float dt);

#endif
