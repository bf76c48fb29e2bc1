// SPDX-License-Identifier: MIT
// shader.h -- compiles and links OpenGL programs from the texts of glsl.h.
#ifndef SHADER_H
#define SHADER_H
#include <stddef.h>

#define SENTENCE 512 // size of a buffer for an error message, characters

// Creates a program from a vertex shader and a fragment shader. `head`, which may be empty, is put before the vertex
// shader. On failure returns 0 and writes OpenGL's message.
unsigned shader_link(const char* head, const char* vertex, const char* fragment, char* sentence);

#endif
