// SPDX-License-Identifier: MIT
// level.h -- ground, platforms and crates of the first game. The user data of each body is its color, 0xRRGGBBAA.
#ifndef LEVEL_H
#define LEVEL_H
#include <scree/scree_math.h>

#define COLOR_EARTH 0x4f7a4ce0u
#define COLOR_CRATE 0xc08a4ec0u
#define LEVEL_EDGE  14.0f // m: x of the edge where the ground ends

// Adds a static box: left, bottom, right and top in m.
static inline void level_block(scree_world* world, float left, float bottom, float right, float top)
{
	scree_pose pose = scree_pose_make(0.5f * (left + right), 0.5f * (bottom + top), 0.0f);
	scree_body_create_box(world, SCREE_BODY_STATIC, pose, 0.5f * (right - left), 0.5f * (top - bottom), COLOR_EARTH,
	                      NULL);
}

static inline void level_create(scree_world* world)
{
	level_block(world, -16.0f, -6.0f, LEVEL_EDGE, 0.0f); // ground
	level_block(world, -17.0f, -6.0f, -16.0f, 6.0f);     // wall
	level_block(world, LEVEL_EDGE, -6.0f, 24.0f, -5.0f); // bottom of the pit
	level_block(world, -4.0f, 1.6f, -1.0f, 2.0f);        // platforms
	level_block(world, 0.5f, 3.4f, 4.5f, 3.8f);
	for (int k = 0; k < 3; ++k)
		scree_body_create_box(world, SCREE_BODY_DYNAMIC, scree_pose_make(-11.0f, 0.5f + (float)k, 0.0f), 0.5f, 0.5f,
		                      COLOR_CRATE, NULL);
}

#endif
