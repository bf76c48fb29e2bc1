// SPDX-License-Identifier: MIT
// framing.h -- the part of the world that the window shows: the whole scene, a part that the user selected, or a
// followed body.
#ifndef FRAMING_H
#define FRAMING_H
#include "view/window/window_state.h"

// Shows the view of the scene file.
void eye_fit_scene(Viewer* viewer);

// Shows the view of the scene file and the current positions of its bodies, except a few outliers.
void eye_fit_bodies(Viewer* viewer);

// Starts or stops following the selected body. Returns false if no body is selected.
bool eye_follow(Viewer* viewer);

// Stops following and fitting, because the user has moved the picture.
void eye_moved(Viewer* viewer);

// Updates the camera; call it before a frame. A fitted box stays fitted when the window or the panel changes, and a
// followed body is moved to the middle.
void eye_frame(Viewer* viewer);

#endif
