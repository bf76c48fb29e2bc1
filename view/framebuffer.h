// SPDX-License-Identifier: MIT
// framebuffer.h -- an OpenGL framebuffer with one color buffer, to draw into and to read.
#ifndef FRAMEBUFFER_H
#define FRAMEBUFFER_H
#include <stdbool.h>

typedef struct // OpenGL names
{
	unsigned framebuffer, color; // color is a renderbuffer; both are 0 if there is no framebuffer
} Framebuffer;

// Creates a framebuffer of 8 bits per channel and binds it. Returns false and creates none if the size is too large for
// OpenGL.
bool framebuffer_open(Framebuffer* framebuffer, int width, int height);
void framebuffer_close(Framebuffer* framebuffer);

#endif
