// SPDX-License-Identifier: MIT
// avalanche.h -- many stones for the first game, enough for a GPU.
#ifndef AVALANCHE_H
#define AVALANCHE_H
#include "level.h"
#include <stdio.h>

#define COLOR_STONE 0x909498c0u

// Adds a heap of round stones, 40 in each row, on ground whose left end is at x, m.
static inline void avalanche_create(scree_world* world, float x, int count)
{
	level_block(world, x, -6.0f, x + 46.0f, 0.0f);
	level_block(world, x + 46.0f, -6.0f, x + 47.0f, 40.0f);
	for (int k = 0; k < count; ++k)
	{
		int row = k / 40, column = k % 40;
		scree_pose pose =
		    scree_pose_make(x + 4.0f + (float)column + 0.5f * (float)(row % 2), 0.5f + 0.9f * (float)row, 0.0f);
		scree_body_create_circle(world, SCREE_BODY_DYNAMIC, pose, 0.45f, COLOR_STONE, NULL);
	}
}

// Prints a sentence of Scree: each decision about the device, and warnings.
static inline void avalanche_log(scree_log_level level, const char* sentence, void* context)
{
	(void)level, (void)context;
	fprintf(stderr, "%s\n", sentence);
}

#endif
