// SPDX-License-Identifier: MIT
// blast_tool.c -- computes and draws explosions at the cursor, which grow while the user holds the key.
#include "view/blast_tool.h"
#include <math.h>

#define FIRST   50.0f  // px: initial radius
#define GROWS   180.0f // px/s: growth of the radius
#define LARGEST 500.0f // px: maximum radius
#define WIDE    1.6f   // width of a typical body, divided by its reach

static const Color flame = {222, 84, 20};

float blast_radius(double seconds) { return fminf(FIRST + GROWS * (float)seconds, LARGEST); }

float blast_impulse(const RenderTables* tables, float speed)
{
	// mass of a typical body divided by its width
	return speed * fmaxf(tables->density * WIDE * tables->size, 1.0e-6f);
}

void blast_mark(Strokes* strokes, scree_vec at, float radius)
{
	strokes_ring(strokes, at, 2.0f * radius, 2.5f, flame, 230);
	strokes_ring(strokes, at, 4.0f * radius, 1.0f, flame, 140);
}
