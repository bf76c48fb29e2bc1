// SPDX-License-Identifier: MIT
// framebuffer.h -- creates an OpenGL framebuffer with one color buffer, to draw into and to read from.
#ifndef FRAMEBUFFER_H
#define FRAMEBUFFER_H
#include <stdbool.h>

typedef struct // names of OpenGL objects
{
	unsigned framebuffer, color; // color: a renderbuffer; both names are 0 if no framebuffer was created
} Framebuffer;

// Creates a framebuffer of 8 bits per channel and binds it. If the size is too large for OpenGL, creates nothing and
// returns false.
bool framebuffer_open(Framebuffer* framebuffer, int width, int height);
void framebuffer_close(Framebuffer* framebuffer);

#endif
