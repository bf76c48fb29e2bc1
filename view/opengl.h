// SPDX-License-Identifier: MIT
// opengl.h -- includes OpenGL 3.3 (from libepoxy) or, in a page, OpenGL ES 3.0 (from WebGL 2). Macros hide the
// differences.
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
#define OPENGL_SHADERS_SIZE_POINTS() ((void)0) // does nothing: in WebGL, shaders always set the size of points
#else
#include <epoxy/gl.h>
#define GLSL_VERSION                 "#version 330 core\n"
#define OPENGL_SHADERS_SIZE_POINTS() glEnable(GL_PROGRAM_POINT_SIZE)
#endif

#endif
