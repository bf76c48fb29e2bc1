// common.glsl -- the beginning of every shader, after its version: where an array of texels has its elements.
ivec2 cell(int k) { return ivec2(k & 2047, k >> 11); } // 2048 texels a row, as render_tables.c has it
