// SPDX-License-Identifier: MIT
// frame.c -- a picture of OpenGL to draw into and to read, which nobody sees.
#include "view/frame.h"
#include <epoxy/gl.h>

bool frame_open(Frame* f, int width, int height)
{
	glGenRenderbuffers(1, &f->color);
	glBindRenderbuffer(GL_RENDERBUFFER, f->color);
	glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
	glGenFramebuffers(1, &f->frame);
	glBindFramebuffer(GL_FRAMEBUFFER, f->frame);
	glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, f->color);
	bool good = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
	if (!good)
		frame_close(f);
	return good;
}

void frame_close(Frame* f)
{
	glDeleteFramebuffers(1, &f->frame);
	glDeleteRenderbuffers(1, &f->color);
	*f = (Frame){0};
}
