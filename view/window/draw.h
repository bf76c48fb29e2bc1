// SPDX-License-Identifier: MIT
// draw.h -- one frame of the window: the world, what the cursor holds, the panel.
#ifndef DRAW_H
#define DRAW_H
#include "view/window/window_state.h"

// Draws a frame and shows it. A world whose device failed ends the viewer.
void draw_frame(Viewer* viewer);

#endif
