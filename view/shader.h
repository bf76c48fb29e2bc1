// SPDX-License-Identifier: MIT
// shader.h -- programs of OpenGL from the texts of glsl.h.
#ifndef SHADER_H
#define SHADER_H
#include <stddef.h>

#define SENTENCE 512 // characters of what went wrong

// The program of a vertex and a fragment shader; head (may be empty) stands before the vertex shader. Returns 0 and
// writes what OpenGL says when it does not build.
unsigned shader_link(const char* head, const char* vertex, const char* fragment, char* sentence);

#endif
