// SPDX-License-Identifier: MIT
// pass.h -- opens an OpenGL program that draws rows, and sets its uniforms from camera and style.
#ifndef PASS_H
#define PASS_H
#include "view/camera.h"
#include "view/render_tables.h"
#include "view/style.h"

typedef struct // an OpenGL program and the locations of its uniforms
{
	unsigned program;
	int view, scale, paint, least, size, line, coarse, first, marked, sensors, ramp, types, still, glass, ink;
	int sleeps, ground;
} Pass;

// Links a program from row.glsl and two texts. Returns false and writes a sentence (SENTENCE of shader.h) on failure.
bool pass_open(Pass* pass, const char* vertex, const char* fragment, char* sentence);
void pass_close(Pass* pass);

// Makes the program current, and sets its uniforms for drawing all rows.
void pass_use(const Pass* pass, const RenderTables* tables, const Camera* camera, const Style* style);

// Binds the textures of the tables, which all programs for rows read.
void pass_bind_tables(const RenderTables* tables);

#endif
