// SPDX-License-Identifier: MIT
// framing.h -- selects the part of the world that the window shows: the whole scene, a part that the user selected, or
// a followed body.
#ifndef FRAMING_H
#define FRAMING_H
#include "view/window/window_state.h"

// Shows the view in the scene file or, if there is none, the bodies that move.
void eye_fit_scene(Viewer* viewer);

// Shows a box around most dynamic bodies, without outliers. If the scene file has a view, also shows this view.
void eye_fit_bodies(Viewer* viewer);

// Starts to follow the selected body or, if a body is already followed, stops following it. Returns false if there is
// no body to follow.
bool eye_follow(Viewer* viewer);

// Stops following a body and fitting a box, because the user has moved the picture.
void eye_moved(Viewer* viewer);

// Updates the camera; call it before a frame. If a box is fitted, fits it again, because the window or the panel may
// have changed. Moves a followed body towards the middle of the picture.
void eye_frame(Viewer* viewer);

#endif
