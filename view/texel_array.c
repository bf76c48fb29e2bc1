// SPDX-License-Identifier: MIT
// texel_array.c -- keeps an array in an OpenGL texture, for shaders that read the array.
#include "view/texel_array.h"
#include "view/opengl.h"

#define WIDTH 2048 // texels per row, as in common.glsl; every WebGL 2 supports this width

static const struct
{
	GLint internal;
	GLenum format, type;
	size_t bytes; // bytes per texel
} formats[] = {
    {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1},
    {GL_RG32F, GL_RG, GL_FLOAT, 8},
    {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16},
};

// Creates a texture with more rows than needed, so that a growing world rarely replaces it.
static void texel_array_make(TexelArray* t, TexelFormat format, int rows)
{
	if (!t->texture)
		glGenTextures(1, &t->texture);
	t->format = (int)format;
	t->rows = rows + rows / 2;
	glBindTexture(GL_TEXTURE_2D, t->texture);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
	glTexImage2D(GL_TEXTURE_2D, 0, formats[format].internal, WIDTH, t->rows, 0, formats[format].format,
	             formats[format].type, NULL);
}

void texel_array_fill(TexelArray* t, TexelFormat format, const void* data, int count)
{
	const GLenum layout = formats[format].format, type = formats[format].type;
	const int full = count / WIDTH, rest = count % WIDTH, rows = full + (rest > 0);
	if (!t->texture || t->format != (int)format || t->rows < rows)
		texel_array_make(t, format, rows);
	glBindTexture(GL_TEXTURE_2D, t->texture);
	glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
	if (full > 0)
		glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WIDTH, full, layout, type, data);
	if (rest > 0)
		glTexSubImage2D(GL_TEXTURE_2D, 0, 0, full, rest, 1, layout, type,
		                (const char*)data + formats[format].bytes * WIDTH * (size_t)full);
	glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void texel_array_delete(TexelArray* t)
{
	glDeleteTextures(1, &t->texture);
	*t = (TexelArray){0};
}
