// SPDX-License-Identifier: MIT
// offscreen.h -- OpenGL without a window: a context, and a picture to draw into.
#ifndef OFFSCREEN_H
#define OFFSCREEN_H
#include "view/frame.h"
#include <stdint.h>

typedef struct
{
	void *display, *context; // of EGL
	Frame frame;
	int width, height;  // px
	char renderer[128]; // what OpenGL says of itself
} Offscreen;

// Opens a context of OpenGL 3.3 and makes it current, on the first device of EGL that has one: GPUs come before
// software. Returns null or why not.
const char* offscreen_open(Offscreen* offscreen, int width, int height);
void offscreen_close(Offscreen* offscreen);

// A hash of all pixels, FNV-1a (Glenn Fowler, Landon Curt Noll, Kiem-Phong Vo, 1991); 0 when there is no memory. Waits
// for what is drawn.
uint64_t offscreen_hash(const Offscreen* offscreen);

#endif
