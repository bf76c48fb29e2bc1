// SPDX-License-Identifier: MIT
// viewer.h -- operations on the viewer's state: load a scene, change the device, read the world, tell the user.
#ifndef VIEWER_H
#define VIEWER_H
#include "view/window/window_state.h"

// Shows a message to the user for some seconds.
void viewer_show(Viewer* viewer, const char* message);

// Ends the viewer with a sentence.
void viewer_fail(Viewer* viewer, const char* sentence);

// Reads the world again after it was replaced, or after bodies were added or removed. False ends the viewer.
bool viewer_update_world(Viewer* viewer);

// Reads everything that a style shows of the world as it is now. False ends the viewer: the world's device failed.
bool viewer_fetch(Viewer* viewer, const Style* style);

// Reads the numbers of what is under the cursor, if over is true, and of what was selected. False ends the viewer.
bool viewer_inspect(Viewer* viewer, bool over);

// Selects what is under the cursor; nothing ends the selection.
void viewer_select(Viewer* viewer);

// Loads a scene; false shows a message. fresh: with the parameters of the options, else with those of the panel.
bool viewer_load(Viewer* viewer, const char* name, bool fresh);

// Moves the world to a device and shows whether the hash is the same; false shows a message.
bool viewer_move(Viewer* viewer, const char* device);

#endif
