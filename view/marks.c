// SPDX-License-Identifier: MIT
// marks.c -- the plainest picture of a world: every row a rectangle or a disk, as large as its shape.
#include "view/marks.h"
#include <epoxy/gl.h>
#include <stddef.h>
#include <stdlib.h>

// A row is an instance of four corners. The table holds, of each attribute, the rectangle around it in its own
// coordinates, and whether to cut the corners off.
static const char vertex_text[] =
    "#version 330 core\n"
    "layout(location = 0) in vec4 pose;\n"
    "layout(location = 1) in ivec2 name;\n"
    "uniform vec4 view;\n" // center, and 1 / half size
    "uniform samplerBuffer sizes;\n"
    "out vec2 corner;\n"
    "flat out vec4 color;\n"
    "void main()\n"
    "{\n"
    "	corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;\n"
    "	vec4 middle = texelFetch(sizes, 2 * max(name.x, 0));\n"
    "	vec4 more = texelFetch(sizes, 2 * max(name.x, 0) + 1);\n"
    "	vec2 local = middle.xy + corner * middle.zw;\n"
    "	vec2 world = pose.xy + vec2(pose.z * local.x - pose.w * local.y,\n"
    "	                            pose.w * local.x + pose.z * local.y);\n"
    "	gl_Position = name.x < 0 ? vec4(2.0) : vec4((world - view.xy) * view.zw, 0.0, 1.0);\n"
    "	uint hash = uint(name.y) * 2654435761u;\n"
    "	color = vec4(0.4 + 0.6 * vec3(hash >> 24, hash >> 16 & 255u, hash >> 8 & 255u) / 255.0,\n"
    "	             more.x);\n"
    "}\n";
static const char fragment_text[] = "#version 330 core\n"
                                    "in vec2 corner;\n"
                                    "flat in vec4 color;\n"
                                    "out vec4 pixel;\n"
                                    "void main()\n"
                                    "{\n"
                                    "	if (color.w > 0.0 && dot(corner, corner) > 1.0)\n"
                                    "		discard;\n"
                                    "	pixel = vec4(color.xyz, 1.0);\n"
                                    "}\n";

static bool attach(GLuint program, GLenum kind, const char* text)
{
	GLuint shader = glCreateShader(kind);
	glShaderSource(shader, 1, &text, NULL);
	glCompileShader(shader);
	GLint good = 0;
	glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
	glAttachShader(program, shader);
	glDeleteShader(shader);
	return good;
}

// the rectangle around a shape, its middle and half its sides, then 1 for a disk
static void measure(const scree_shape* shape, float size[8])
{
	scree_box box = {shape->vertices[0], shape->vertices[0]};
	for (int k = 1; k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k];
		box.lower.x = v.x < box.lower.x ? v.x : box.lower.x;
		box.lower.y = v.y < box.lower.y ? v.y : box.lower.y;
		box.upper.x = v.x > box.upper.x ? v.x : box.upper.x;
		box.upper.y = v.y > box.upper.y ? v.y : box.upper.y;
	}
	size[0] = 0.5f * (box.lower.x + box.upper.x);
	size[1] = 0.5f * (box.lower.y + box.upper.y);
	size[2] = 0.5f * (box.upper.x - box.lower.x) + shape->radius;
	size[3] = 0.5f * (box.upper.y - box.lower.y) + shape->radius;
	size[4] = shape->kind == SCREE_CIRCLE;
}

const char* marks_open(Marks* m, const scree_attribute_def* attributes, int count)
{
	*m = (Marks){.program = glCreateProgram()};
	bool good = attach(m->program, GL_VERTEX_SHADER, vertex_text);
	good = attach(m->program, GL_FRAGMENT_SHADER, fragment_text) && good;
	GLint linked = 0;
	glLinkProgram(m->program);
	glGetProgramiv(m->program, GL_LINK_STATUS, &linked);
	float* sizes = calloc((size_t)count + 1, 8 * sizeof(float));
	if (!good || !linked || !sizes)
	{
		free(sizes);
		marks_close(m);
		return sizes ? "OpenGL does not compile the shaders of the marks" : "there is no memory for the marks";
	}
	for (int k = 0; k < count; ++k)
		measure(&attributes[k].shape, sizes + 8 * k);
	glGenBuffers(1, &m->sizes);
	glBindBuffer(GL_TEXTURE_BUFFER, m->sizes);
	glBufferData(GL_TEXTURE_BUFFER, ((GLsizeiptr)count + 1) * 8 * (GLsizeiptr)sizeof(float), sizes, GL_STATIC_DRAW);
	free(sizes);
	glGenTextures(1, &m->table);
	glBindTexture(GL_TEXTURE_BUFFER, m->table);
	glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, m->sizes);
	glGenVertexArrays(1, &m->vertices);
	m->view = glGetUniformLocation(m->program, "view");
	return NULL;
}

void marks_draw(const Marks* m, unsigned buffer, int count, scree_box view)
{
	glBindVertexArray(m->vertices);
	glBindBuffer(GL_ARRAY_BUFFER, buffer);
	const GLsizei row = sizeof(scree_shown);
	glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, row, (void*)offsetof(scree_shown, pose));
	glVertexAttribIPointer(1, 2, GL_INT, row, (void*)offsetof(scree_shown, attribute));
	for (GLuint k = 0; k < 2; ++k)
	{
		glEnableVertexAttribArray(k);
		glVertexAttribDivisor(k, 1);
	}
	glUseProgram(m->program);
	glUniform4f(m->view, 0.5f * (view.lower.x + view.upper.x), 0.5f * (view.lower.y + view.upper.y),
	            2.0f / (view.upper.x - view.lower.x), 2.0f / (view.upper.y - view.lower.y));
	glBindTexture(GL_TEXTURE_BUFFER, m->table);
	glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

void marks_close(Marks* m)
{
	glDeleteVertexArrays(1, &m->vertices);
	glDeleteTextures(1, &m->table);
	glDeleteBuffers(1, &m->sizes);
	glDeleteProgram(m->program);
	*m = (Marks){0};
}
