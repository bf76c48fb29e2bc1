// SPDX-License-Identifier: MIT
// player.h -- the scene player: fills a world with a scene, and applies churn, characters and keys before each step.
#ifndef PLAYER_H
#define PLAYER_H
#include "scene/character_motion.h"
#include "scene/scan.h"

typedef struct
{
	const Scene* scene;
	scree_world* world;
	bool owns;                          // true if player_close destroys the world
	double opening, building, scanning; // s: time for creating the world, for filling it, and for the last rays
	int64_t steps;                      // number of steps that have been taken
	uint32_t down;                      // keys that the user holds: bits by SceneKey; set by the caller
	Characters characters;
	Scan scan;        // rays after the last step
	ScanSum answered; // sums of the results of all rays
} ScenePlayer;

// Creates a world from a definition, and fills it with the scene. The caller closes the player also on failure.
scree_status player_open(ScenePlayer* player, const Scene* scene, const scree_world_def* def);

// Fills an empty world with the scene. The caller destroys the world, and closes the player also on failure.
scree_status player_fill(ScenePlayer* player, const Scene* scene, scree_world* world);
void player_close(ScenePlayer* player);

// Applies the changes of the scene before a step (churn, explosions, characters, keys), then takes the step.
scree_status player_step(ScenePlayer* player);
// player_change applies the changes before a step; player_advance takes the step.
scree_status player_change(ScenePlayer* player);
scree_status player_advance(ScenePlayer* player);

// Casts the rays of the scene, if it has any, and adds their results to ScenePlayer.answered.
scree_status player_scan(ScenePlayer* player);

// Returns the keys that a scene uses: bits by SceneKey.
uint32_t player_keys(const Scene* scene);

#endif
