// SPDX-License-Identifier: MIT
// full_screen.h -- the window over the whole screen, and back to where it was.
#ifndef FULL_SCREEN_H
#define FULL_SCREEN_H
#include "view/window/window_state.h"

void full_toggle(Viewer* viewer);

#endif
