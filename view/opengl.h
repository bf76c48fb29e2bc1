// SPDX-License-Identifier: MIT
// opengl.h -- OpenGL 3.3 by libepoxy, or WebGL 2 in a page, which is OpenGL ES 3.0; and the few differences between
// them.
#ifndef OPENGL_H
#define OPENGL_H
#include <stdbool.h>
#include <stddef.h>

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#define GLSL_VERSION               \
	"#version 300 es\n"            \
	"precision highp float;\n"     \
	"precision highp int;\n"       \
	"precision highp sampler2D;\n" \
	"precision highp usampler2D;\n"
#define OPENGL_SHADERS_SIZE_POINTS() ((void)0) // always enabled in WebGL
#else
#include <epoxy/gl.h>
#define GLSL_VERSION                 "#version 330 core\n"
#define OPENGL_SHADERS_SIZE_POINTS() glEnable(GL_PROGRAM_POINT_SIZE)
#endif

#endif
