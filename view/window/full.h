// SPDX-License-Identifier: MIT
// full.h -- the window over the whole screen, and back to where it was.
#ifndef FULL_H
#define FULL_H
#include "view/window/state.h"

void full_toggle(Viewer* viewer);

#endif
