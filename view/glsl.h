// SPDX-License-Identifier: MIT
// glsl.h -- declares the shaders of view/glsl as strings; cmake/texts.cmake writes the strings.
#ifndef GLSL_H
#define GLSL_H

extern const char glsl_common_glsl[], glsl_row_glsl[];
extern const char glsl_body_vert[], glsl_body_frag[];
extern const char glsl_splat_vert[], glsl_splat_frag[];
extern const char glsl_box_vert[], glsl_box_frag[];
extern const char glsl_velocity_vert[], glsl_center_vert[];
extern const char glsl_stroke_vert[], glsl_stroke_frag[];

#endif
