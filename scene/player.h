// SPDX-License-Identifier: MIT
// player.h -- a scene in its world, step by step.
#ifndef PLAYER_H
#define PLAYER_H
#include "scene/character_motion.h"
#include "scene/scan.h"

typedef struct
{
	const Scene* scene;
	scree_world* world;
	bool owns;                          // true if player_close destroys the world
	double opening, building, scanning; // s: durations of creating the world, of filling it, and of the last scan
	int64_t steps;                      // number of steps so far
	uint32_t down;                      // keys that the user holds: bits by SceneKey; set by the caller
	Characters characters;
	Scan scan;        // rays of the last scan
	ScanSum answered; // sums of the results of all scans
} ScenePlayer;

// Creates a world from a definition, and the scene in it. The caller closes the player also on failure.
scree_status player_open(ScenePlayer* player, const Scene* scene, const scree_world_def* def);

// Creates the scene in an empty world, which the caller destroys. The caller closes the player also on failure.
scree_status player_fill(ScenePlayer* player, const Scene* scene, scree_world* world);
void player_close(ScenePlayer* player);

// Applies the changes of the scene before a step (churn, explosions, characters, keys), then takes the step.
scree_status player_step(ScenePlayer* player);
// Do the two parts of player_step: the changes, and the step.
scree_status player_change(ScenePlayer* player);
scree_status player_advance(ScenePlayer* player);

// Casts the rays of the scene, if it has any, and adds their results to ScenePlayer.answered.
scree_status player_scan(ScenePlayer* player);

// Returns the keys that a scene uses: bits by SceneKey.
uint32_t player_keys(const Scene* scene);

#endif
