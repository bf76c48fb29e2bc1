// SPDX-License-Identifier: MIT
// full_screen.h -- switches the window to full screen, and back to its earlier place on the screen.
#ifndef FULL_SCREEN_H
#define FULL_SCREEN_H
#include "view/window/window_state.h"

void full_toggle(Viewer* viewer);

#endif
