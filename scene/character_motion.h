// SPDX-License-Identifier: MIT
// character_motion.h -- moves the characters of a scene before each step, by their scripts or by the keys of the user.
#ifndef CHARACTER_MOTION_H
#define CHARACTER_MOTION_H
#include "scene/character.h"

typedef struct // state of the characters beside their movers
{
	uint32_t before; // keys that were down in the last step for any character
	uint32_t played; // 1 after the user has held a key; the scripts then end
	int taken;       // number of bodies that the characters took
} CharacterState;

typedef struct
{
	const Scene* scene;
	scree_body* bodies; // bodies of the scene, in the order of the file
	int body_count;
	scree_mover* movers; // movers of the characters
	CharacterState state;
} Characters;

// Returns the keys that characters use: bits by SceneKey.
uint32_t characters_keys(const Scene* scene);

// Opens the characters in a world that scene_build has filled. The caller closes the characters also on failure.
scree_status characters_open(Characters* characters, const Scene* scene, scree_world* world);
void characters_close(Characters* characters);

// Moves the characters before a step; the first step is number 0. down: keys that the user holds. Sets the targets of
// the characters' bodies, and disables the bodies that characters took in the last step.
scree_status characters_move(Characters* characters, scree_world* world, int64_t step, uint32_t down);

#endif
