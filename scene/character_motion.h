// SPDX-License-Identifier: MIT
// character_motion.h -- moves the characters of a scene before each step, by their scripts or by the keys of the user.
#ifndef CHARACTER_MOTION_H
#define CHARACTER_MOTION_H
#include "scene/character.h"

typedef struct
{
	const Scene* scene;
	scree_body* bodies; // of the scene, in the order of the file
	int body_count;
	scree_mover* movers; // of the characters
	uint32_t before;     // keys that were down in the last step
	bool played;         // the user has held a key: the scripts are over
	int taken;           // bodies that the characters took
} Walkers;

// The keys that characters obey: bits by SceneKey.
uint32_t walk_keys(const Scene* scene);

// The world must have been built by scene_build. On failure the caller closes the walkers also.
scree_status walk_open(Walkers* walkers, const Scene* scene, scree_world* world);
void walk_close(Walkers* walkers);

// Before a step; the first one is number 0. down: keys that the user holds. Moves the characters, sends their bodies after them, and
// disables what they took in the last step.
scree_status walk_step(Walkers* walkers, scree_world* world, int64_t step, uint32_t down);

#endif
