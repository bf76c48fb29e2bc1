// common.glsl -- the beginning of every shader, after the version: computes the position of an element in a texel
// array.
ivec2 cell(int k) { return ivec2(k & 2047, k >> 11); } // 2048 texels per row, as in texel_array.c
