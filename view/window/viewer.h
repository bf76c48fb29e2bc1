// SPDX-License-Identifier: MIT
// viewer.h -- changes the viewer's state: loads a scene, moves the world to a device, reads the world, shows messages.
#ifndef VIEWER_H
#define VIEWER_H
#include "view/window/window_state.h"

// Shows a message to the user for some seconds.
void viewer_show(Viewer* viewer, const char* message);

// Prints a sentence, and ends the viewer with exit code 1.
void viewer_fail(Viewer* viewer, const char* sentence);

// Reads the world again after it was replaced, or after bodies were added or removed. On failure ends the viewer and
// returns false.
bool viewer_update_world(Viewer* viewer);

// Opens a wall of worlds (wall.h) without the panel. Writes a sentence (SENTENCE of shader.h) and returns false on failure.
bool viewer_open_wall(Viewer* viewer, char* sentence);

// Takes a step of the wall. On failure ends the viewer and returns false.
bool viewer_step_wall(Viewer* viewer);

// Computes the hash of the world, or of the first one of a wall.
scree_status viewer_hash(Viewer* viewer, uint64_t* hash);

// Reads all data of the current world that a style shows. If the device failed, ends the viewer and returns false.
bool viewer_fetch(Viewer* viewer, const Style* style);

// Reads the numbers of the selected collidable and, if `over` is true, of the collidable under the cursor. On failure
// ends the viewer and returns false.
bool viewer_inspect(Viewer* viewer, bool over);

// Selects the collidable under the cursor. If there is none, clears the selection.
void viewer_select(Viewer* viewer);

// Loads a scene or a recording. fresh: true for the parameters of the options, false for those of the panel. On failure shows a
// message and returns false.
bool viewer_load(Viewer* viewer, const char* name, bool fresh);

// Returns true if the user may change the world. The calls of a recording are only repeated, and the worlds of a wall get
// their own inputs: shows a message and returns false.
bool viewer_may_change(Viewer* viewer);

// Moves the world to a device, and shows whether the hash is the same before and after. On failure shows a message and
// returns false.
bool viewer_move(Viewer* viewer, const char* device);

#endif
