// SPDX-License-Identifier: MIT
// blast_tool.h -- explosions that grow as long as the user holds them back.
#ifndef BLAST_TOOL_H
#define BLAST_TOOL_H
#include "view/render_tables.h"
#include "view/stroke.h"

#define BLAST_SPEED 15.0f // m/s that a common body near an explosion gets, where nobody chooses another one

// px: nearer bodies get all of an explosion that was held for so many seconds, and those twice as far away nothing.
float blast_radius(double seconds);

// The impulse, N s a metre of width, that gives a body as large and dense as most of the world's this speed, m/s.
float blast_impulse(const RenderTables* tables, float speed);

// Shows how far an explosion would reach; radius in px.
void blast_mark(Strokes* strokes, scree_vec at, float radius);

#endif
