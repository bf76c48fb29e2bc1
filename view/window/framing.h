// SPDX-License-Identifier: MIT
// framing.h -- what the window shows of the world: all of the scene beside the panel, what the user moves to, or a body that is followed.
#ifndef FRAMING_H
#define FRAMING_H
#include "view/window/window_state.h"

// Shows the scene as its file has it.
void eye_fit_scene(Viewer* viewer);

// Shows the scene, and where its bodies are now, without a few that flew far away.
void eye_fit_bodies(Viewer* viewer);

// Follows the selected body, or ends that. False if there is none.
bool eye_follow(Viewer* viewer);

// The user has moved the picture.
void eye_moved(Viewer* viewer);

// Before a frame: a picture that showed all still does when the window or the panel has changed; what is followed is in the middle.
void eye_frame(Viewer* viewer);

#endif
