// SPDX-License-Identifier: MIT
// shader.c -- compiles and links OpenGL programs from the texts of glsl.h.
#include "view/shader.h"
#include "view/glsl.h"
#include "view/opengl.h"
#include <stdio.h>

static bool attach(GLuint program, GLenum kind, const char* head, const char* text, char* sentence)
{
	GLuint shader = glCreateShader(kind);
	const char* texts[] = {GLSL_VERSION, glsl_common_glsl, head, text};
	glShaderSource(shader, 4, texts, NULL);
	glCompileShader(shader);
	GLint good = 0;
	glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
	if (!good)
	{
		char log[384] = "";
		glGetShaderInfoLog(shader, sizeof log, NULL, log);
		snprintf(sentence, SENTENCE, "OpenGL does not compile a shader: %s", log);
	}
	glAttachShader(program, shader);
	glDeleteShader(shader);
	return good;
}

unsigned shader_link(const char* head, const char* vertex, const char* fragment, char* sentence)
{
	GLuint program = glCreateProgram();
	GLint linked = 0;
	if (attach(program, GL_VERTEX_SHADER, head, vertex, sentence) &&
	    attach(program, GL_FRAGMENT_SHADER, "", fragment, sentence))
	{
		glLinkProgram(program);
		glGetProgramiv(program, GL_LINK_STATUS, &linked);
		if (!linked)
			snprintf(sentence, SENTENCE, "OpenGL does not link the shaders");
	}
	if (linked)
		return program;
	glDeleteProgram(program);
	return 0;
}
