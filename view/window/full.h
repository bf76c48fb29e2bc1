// SPDX-License-Identifier: MIT
// full.h -- the window over the whole screen, and back to where it was.
#ifndef FULL_H
#define FULL_H

typedef struct // of the window when it does not fill the screen, in window units
{
	int x, y, width, height;
} Place;

typedef struct Viewer Viewer;

void full_toggle(Viewer* viewer);

#endif
