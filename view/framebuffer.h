// SPDX-License-Identifier: MIT
// framebuffer.h -- an OpenGL framebuffer with one color buffer, to draw into and to read.
#ifndef FRAMEBUFFER_H
#define FRAMEBUFFER_H
#include <stdbool.h>

typedef struct // OpenGL names
{
	unsigned framebuffer, color; // color: renderbuffer; both 0 when there is none
} Framebuffer;

// Makes a framebuffer of 8 bits a channel and binds it. False makes none: the size is too large for OpenGL.
bool framebuffer_open(Framebuffer* framebuffer, int width, int height);
void framebuffer_close(Framebuffer* framebuffer);

#endif
