// SPDX-License-Identifier: MIT
// wall.h -- a wall of worlds: copies of the scene in one batch, with different inputs, drawn side by side.
#ifndef WALL_H
#define WALL_H
#include "scene/wall_inputs.h"
#include "view/renderer.h"

#define WALL_MOST 1024 // maximum number of worlds

typedef struct
{
	scree_batch* batch; // null: there is no wall
	const Scene* scene;
	int worlds, columns; // number of worlds; worlds side by side in a row of the wall
	int64_t steps;       // steps since the start
	WallInputs inputs;
	scree_pose* places;     // pose of each render row in the frame of its body, or in the world
	scree_vec* centers;     // center of mass of each row, from its position, in the same frame
	int* body_of;           // for each row, its number in the list of bodies whose poses are read; -1: it stands still
	scree_render_row* rows; // rows of one world as the template has them, then those of all worlds
	scree_box* boxes;       // m: tile of each world
	scree_box box;          // m: box around all tiles
	int row_count;          // render rows of one world
	scree_batch_counters* counters;
} Wall;

// Functions that return bool write a sentence (SENTENCE of shader.h) and return false on failure.

// Makes a batch of copies of the world of a scene. def: number of worlds, and their device; without templates. The caller closes
// the wall also on failure.
bool wall_open(Wall* wall, const Scene* scene, scree_world* world, const scree_batch_def* def, char* sentence);
void wall_close(Wall* wall);

// Arranges the tiles. view: part of the world that each of them shows, m.
void wall_place(Wall* wall, scree_box view);

// Draws random inputs twice a second, and takes a step: speeds of motors or, in a scene without motors, pushes of all
// bodies. The first world has none, so it moves as the scene does alone. Sums the counters of all worlds.
scree_status wall_step(Wall* wall, scree_counters* counters);

// Sums the counters of all worlds. counters: keeps the number of bodies.
scree_status wall_count(Wall* wall, scree_counters* counters);

// Returns the first world that is paused because it has too many contacts; -1 if there is none.
int wall_stopped(const Wall* wall);

// Returns all worlds to their start.
scree_status wall_restart(Wall* wall, scree_counters* counters);

// Writes the rows of all worlds into a buffer. On failure share_error returns the sentence.
scree_status wall_show(Wall* wall, Share* share);

// Returns whether a paint shows the worlds of a wall: one that depends neither on contacts nor on velocities.
bool wall_paints(Paint paint);

// Computes the hash of the first world.
scree_status wall_hash(const Wall* wall, uint64_t* hash);

#endif
