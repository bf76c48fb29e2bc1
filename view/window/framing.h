// SPDX-License-Identifier: MIT
// framing.h -- selects the part of the world that the window shows: the whole scene, a part that the user selected, or
// a followed body.
#ifndef FRAMING_H
#define FRAMING_H
#include "view/window/window_state.h"

// Shows the view in the scene file or, if there is none, the bodies that move.
void eye_fit_scene(Viewer* viewer);

// Shows the current positions of the bodies without outliers and, if the scene file has a view, this view too.
void eye_fit_bodies(Viewer* viewer);

// Starts or stops following the selected body. Returns false if no body is selected.
bool eye_follow(Viewer* viewer);

// Stops following and fitting, because the user has moved the picture.
void eye_moved(Viewer* viewer);

// Updates the camera; call it before a frame. Fits a fitted box again, because the window or the panel may have
// changed. Moves a followed body towards the middle.
void eye_frame(Viewer* viewer);

#endif
