// SPDX-License-Identifier: MIT
// frame.h -- a picture of OpenGL to draw into and to read, which nobody sees.
#ifndef FRAME_H
#define FRAME_H
#include <stdbool.h>

typedef struct // names of OpenGL
{
	unsigned frame, color; // framebuffer and renderbuffer; frame is 0 when there is none
} Frame;

// Makes one of 8 bits a channel, and current. False, and none, when OpenGL cannot: when it is too large.
bool frame_open(Frame* frame, int width, int height);
void frame_close(Frame* frame);

#endif
