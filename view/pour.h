// SPDX-License-Identifier: MIT
// pour.h -- pours bodies like those of a scene into its world where there is room. The same calls before the same steps
// pour the same bodies.
#ifndef POUR_H
#define POUR_H
#include "view/stroke.h"

#define POUR_KINDS 16
#define POUR_RATE  4  // default rate
#define POUR_MOST  16 // maximum rate

typedef struct
{
	int rate;   // maximum number of bodies per step
	bool on;    // true: bodies are poured before each step
	bool due;   // true: bodies are poured before the next step, even if pouring has been stopped since
	float size; // m: reach of a typical body
	scree_attribute kinds[POUR_KINDS];
	int kind_count;
	int poured; // number of bodies so far
} Pour;

// Finds the attributes that are poured: those of bodies that have one shape and are not much larger than most. If it
// finds none, kind_count is 0 and nothing is poured.
scree_status pour_begin(Pour* pour, scree_world* world);
void pour_end(Pour* pour);

// Pours bodies around a point (m); call it before a step. Sets added to true if it added any.
scree_status pour_step(Pour* pour, scree_world* world, scree_vec at, bool* added);

// Adds the circle in which bodies are poured, if pouring is on.
void pour_mark(const Pour* pour, Strokes* strokes, scree_vec at, float scale);

#endif
