// SPDX-License-Identifier: MIT
// stroke.c -- collects lines and dots over a picture, and draws them with one call.
#include "view/stroke.h"
#include "view/glsl.h"
#include "view/opengl.h"
#include "view/shader.h"
#include <stdlib.h>

bool strokes_open(Strokes* strokes, char* sentence)
{
	*strokes = (Strokes){.program = shader_link("", glsl_stroke_vert, glsl_stroke_frag, sentence)};
	if (!strokes->program)
		return false;
	strokes->view = glGetUniformLocation(strokes->program, "view");
	strokes->scale = glGetUniformLocation(strokes->program, "scale");
	glGenVertexArrays(1, &strokes->vertices);
	glGenBuffers(1, &strokes->buffer);
	glBindVertexArray(strokes->vertices);
	glBindBuffer(GL_ARRAY_BUFFER, strokes->buffer);
	glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Stroke), (void*)offsetof(Stroke, a));
	glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(Stroke), (void*)offsetof(Stroke, width));
	glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Stroke), (void*)offsetof(Stroke, color));
	glVertexAttribPointer(3, 2, GL_UNSIGNED_BYTE, GL_FALSE, sizeof(Stroke), (void*)offsetof(Stroke, end));
	for (GLuint k = 0; k < 4; ++k)
	{
		glEnableVertexAttribArray(k);
		glVertexAttribDivisor(k, 1);
	}
	return true;
}

void strokes_close(Strokes* strokes)
{
	glDeleteVertexArrays(1, &strokes->vertices);
	glDeleteBuffers(1, &strokes->buffer);
	glDeleteProgram(strokes->program);
	free(strokes->list);
	*strokes = (Strokes){0};
}

static void add(Strokes* strokes, const Stroke* stroke)
{
	if (strokes->count == strokes->capacity)
	{
		int capacity = strokes->capacity ? 2 * strokes->capacity : 1024;
		Stroke* list = realloc(strokes->list, (size_t)capacity * sizeof(Stroke));
		if (!list)
			return;
		strokes->list = list;
		strokes->capacity = capacity;
	}
	strokes->list[strokes->count++] = *stroke;
}

void strokes_fade(Strokes* strokes, scree_vec a, scree_vec b, float width, Color color, int begin, int end)
{
	add(strokes, &(Stroke){a, b, width, {color.r, color.g, color.b, (uint8_t)begin}, (uint8_t)end, 0, {0}});
}

void strokes_add(Strokes* strokes, scree_vec a, scree_vec b, float width, Color color, int opacity)
{
	strokes_fade(strokes, a, b, width, color, opacity, opacity);
}

void strokes_ring(Strokes* strokes, scree_vec at, float diameter, float width, Color color, int opacity)
{
	uint8_t line = (uint8_t)(4.0f * width);
	add(strokes,
	    &(Stroke){at, at, diameter, {color.r, color.g, color.b, (uint8_t)opacity}, (uint8_t)opacity, line, {0}});
}

void strokes_draw(Strokes* strokes, const Camera* camera)
{
	if (strokes->count == 0)
		return;
	glBindVertexArray(strokes->vertices);
	glBindBuffer(GL_ARRAY_BUFFER, strokes->buffer);
	glBufferData(GL_ARRAY_BUFFER, strokes->count * (GLsizeiptr)sizeof(Stroke), strokes->list, GL_STREAM_DRAW);
	glUseProgram(strokes->program);
	glUniform4f(strokes->view, camera->middle.x, camera->middle.y, 2.0f * camera->scale / (float)camera->width,
	            2.0f * camera->scale / (float)camera->height);
	glUniform1f(strokes->scale, camera->scale);
	glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, strokes->count);
	strokes->count = 0;
}
