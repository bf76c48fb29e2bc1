// SPDX-License-Identifier: MIT
// texel_array.h -- keeps an array in an OpenGL texture, for shaders that read the array.
#ifndef TEXEL_ARRAY_H
#define TEXEL_ARRAY_H

typedef enum // format of a texel
{
	FORMAT_BYTE, // one byte per texel, R8UI
	FORMAT_TWO,  // two floats per texel, RG32F
	FORMAT_FOUR, // four floats per texel, RGBA32F
} TexelFormat;

typedef struct // texel k is in row k / 2048 of a 2D texture, because WebGL has no buffer textures
{
	unsigned texture;
	int format, rows; // format and number of rows of the texture
} TexelArray;

// Writes the texels from 0 to count - 1; the contents of the other texels are undefined.
void texel_array_fill(TexelArray* array, TexelFormat format, const void* data, int count);
void texel_array_delete(TexelArray* array);

#endif
