// SPDX-License-Identifier: MIT
// offscreen.h -- OpenGL without a window: a context and a framebuffer.
#ifndef OFFSCREEN_H
#define OFFSCREEN_H
#include "view/framebuffer.h"
#include <stdint.h>

typedef struct
{
	void *display, *context; // EGL
	Framebuffer framebuffer;
	int width, height;  // px
	char renderer[128]; // GL_RENDERER
} Offscreen;

// Opens an OpenGL 3.3 context on the first EGL device that has one, and makes it current. EGL lists GPUs before
// software renderers. Returns null, or an error message.
const char* offscreen_open(Offscreen* offscreen, int width, int height);
void offscreen_close(Offscreen* offscreen);

// A hash of all pixels (tools/common/byte_hash.h); 0 when memory is short.
// Waits until drawing is finished.
uint64_t offscreen_hash(const Offscreen* offscreen);

#endif
