// SPDX-License-Identifier: MIT
// framebuffer.c -- creates an OpenGL framebuffer with one color buffer, to draw into and to read from.
#include "view/framebuffer.h"
#include <epoxy/gl.h>

bool framebuffer_open(Framebuffer* f, int width, int height)
{
	glGenRenderbuffers(1, &f->color);
	glBindRenderbuffer(GL_RENDERBUFFER, f->color);
	glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
	glGenFramebuffers(1, &f->framebuffer);
	glBindFramebuffer(GL_FRAMEBUFFER, f->framebuffer);
	glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, f->color);
	bool good = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
	if (!good)
		framebuffer_close(f);
	return good;
}

void framebuffer_close(Framebuffer* f)
{
	glDeleteFramebuffers(1, &f->framebuffer);
	glDeleteRenderbuffers(1, &f->color);
	*f = (Framebuffer){0};
}
