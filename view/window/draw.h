// SPDX-License-Identifier: MIT
// draw.h -- draws one frame of the window: the world, the marks of the tools, the panel.
#ifndef DRAW_H
#define DRAW_H
#include "view/window/window_state.h"

// Draws a frame and displays it. If the device of the world failed, the viewer ends.
void draw_frame(Viewer* viewer);

#endif
