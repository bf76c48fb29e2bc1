// SPDX-License-Identifier: MIT
// offscreen.h -- opens OpenGL without a window: a context and a framebuffer.
#ifndef OFFSCREEN_H
#define OFFSCREEN_H
#include "view/framebuffer.h"
#include <stdint.h>

typedef struct
{
	void *display, *context; // EGLDisplay and EGLContext
	Framebuffer framebuffer;
	int width, height;  // px: size of the framebuffer
	char renderer[128]; // name of the renderer, GL_RENDERER
} Offscreen;

// Opens an OpenGL 3.3 context on the first EGL device with OpenGL 3.3, and makes the context current. EGL lists GPUs
// before software renderers. Returns null on success, else an error message.
const char* offscreen_open(Offscreen* offscreen, int width, int height);
void offscreen_close(Offscreen* offscreen);

// Returns a hash of all pixels (tools/common/byte_hash.h), 0 if memory is short. Blocks until drawing is finished.
uint64_t offscreen_hash(const Offscreen* offscreen);

#endif
