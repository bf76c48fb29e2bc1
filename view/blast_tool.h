// SPDX-License-Identifier: MIT
// blast_tool.h -- computes and draws explosions at the cursor, which grow while the user holds the key.
#ifndef BLAST_TOOL_H
#define BLAST_TOOL_H
#include "view/render_tables.h"
#include "view/stroke.h"

#define BLAST_SPEED 15.0f // m/s: default speed that an explosion gives a typical body near it

// Returns the radius of an explosion, px. seconds: time for which the key was held. Bodies within the radius get the
// whole impulse; bodies beyond twice the radius get no impulse.
float blast_radius(double seconds);

// Returns the impulse, N s per metre of width, that gives a body of typical size and density the velocity `speed`, m/s.
float blast_impulse(const RenderTables* tables, float speed);

// Adds circles at the radius (px) and at twice the radius of an explosion.
void blast_mark(Strokes* strokes, scree_vec at, float radius);

#endif
