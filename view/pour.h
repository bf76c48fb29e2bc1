// SPDX-License-Identifier: MIT
// pour.h -- bodies like those of a scene, poured into its world where there is room. The same calls before the same steps pour the same.
#ifndef POUR_H
#define POUR_H
#include "view/stroke.h"

#define POUR_KINDS 16
#define POUR_RATE  4  // of a Pour, where nobody chooses another one
#define POUR_MOST  16 // rate, at most

typedef struct
{
	int rate;   // bodies a step, at most
	bool on;    // bodies are poured before each step
	bool due;   // and before the next one, also if it was stopped since
	float size; // m: reach of a common body
	scree_attribute kinds[POUR_KINDS];
	int kind_count;
	int poured; // bodies so far
} Pour;

// Finds what is poured: attributes of bodies that have one shape and are not much larger than most. Nothing is poured where
// kind_count stays 0.
scree_status pour_begin(Pour* pour, scree_world* world);
void pour_end(Pour* pour);

// Before a step: pours bodies around a point (m); added becomes true if there were some.
scree_status pour_step(Pour* pour, scree_world* world, scree_vec at, bool* added);

// Shows the disc that is poured into, if it is.
void pour_mark(const Pour* pour, Strokes* strokes, scree_vec at, float scale);

#endif
