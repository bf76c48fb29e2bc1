// SPDX-License-Identifier: MIT
// blast_tool.h -- explosions at the cursor, which grow while the user holds the key.
#ifndef BLAST_TOOL_H
#define BLAST_TOOL_H
#include "view/render_tables.h"
#include "view/stroke.h"

#define BLAST_SPEED 15.0f // speed that an explosion gives a typical body near it, m/s, unless the user sets another one

// Returns the radius of an explosion whose key was held for a time in seconds, px. Nearer bodies get the whole impulse,
// bodies at twice that distance none.
float blast_radius(double seconds);

// Returns the impulse, N s per metre of width, that gives a body of the world's typical size and density this speed,
// m/s.
float blast_impulse(const RenderTables* tables, float speed);

// Adds circles that show the reach of an explosion; radius in px.
void blast_mark(Strokes* strokes, scree_vec at, float radius);

#endif
