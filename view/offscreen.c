// SPDX-License-Identifier: MIT
// offscreen.c -- opens OpenGL without a window: a context and a framebuffer.
#include "view/offscreen.h"
#include "tools/common/byte_hash.h"
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>

#define MAX_EGL_DEVICES 16

// Opens a context on a display, and makes the context current. The display is never terminated, because other
// contexts of the process may use it.
static EGLContext context_of(EGLDisplay display)
{
	if (!eglInitialize(display, NULL, NULL))
		return EGL_NO_CONTEXT;
	const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
	const EGLint version[] = {
	    EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
	    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
	EGLConfig config;
	EGLint configs = 0;
	EGLContext context = EGL_NO_CONTEXT;
	if (eglChooseConfig(display, wanted, &config, 1, &configs) && configs > 0 && eglBindAPI(EGL_OPENGL_API))
		context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
	if (context && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
		return context;
	if (context)
		eglDestroyContext(display, context);
	return EGL_NO_CONTEXT;
}

const char* offscreen_open(Offscreen* o, int width, int height)
{
	*o = (Offscreen){.width = width, .height = height};
	if (!epoxy_has_egl() || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device"))
		return "there is no EGL that draws without a window: install libegl1 and libgl1-mesa-dri (Debian, Ubuntu)";
	EGLDeviceEXT devices[MAX_EGL_DEVICES];
	EGLint count = 0;
	eglQueryDevicesEXT(MAX_EGL_DEVICES, devices, &count);
	for (int k = 0; k < count && !o->context; ++k)
	{
		o->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[k], NULL);
		o->context = context_of(o->display);
	}
	if (!o->context)
		return "no device of EGL has OpenGL 3.3";
	snprintf(o->renderer, sizeof o->renderer, "%s", (const char*)glGetString(GL_RENDERER));
	if (framebuffer_open(&o->framebuffer, width, height))
		return NULL;
	offscreen_close(o);
	return "OpenGL cannot draw a picture of this size";
}

void offscreen_close(Offscreen* o)
{
	if (!o->context)
		return;
	framebuffer_close(&o->framebuffer);
	eglMakeCurrent(o->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
	eglDestroyContext(o->display, o->context);
	*o = (Offscreen){0};
}

uint64_t offscreen_hash(const Offscreen* o)
{
	size_t bytes = (size_t)o->width * (size_t)o->height * 4;
	uint8_t* pixels = malloc(bytes);
	if (!pixels)
		return 0;
	glReadPixels(0, 0, o->width, o->height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
	uint64_t hash = hash_bytes(HASH_BEGIN, pixels, bytes);
	free(pixels);
	return hash;
}
