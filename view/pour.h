// SPDX-License-Identifier: MIT
// pour.h -- pours bodies into a world where there is room. The new bodies have attributes of the scene's bodies. If two
// worlds get the same calls before the same steps, the same bodies are poured.
#ifndef POUR_H
#define POUR_H
#include "view/stroke.h"

#define POUR_KINDS 16
#define POUR_RATE  4  // default number of bodies per step
#define POUR_MOST  16 // maximum number of bodies per step

typedef struct
{
	int rate;   // maximum number of bodies that are poured per step, at most POUR_MOST
	bool on;    // true: bodies are poured before each step
	bool due;   // true: bodies are poured before the next step, even if pour_end is called before this step
	float size; // m: reach of a typical body
	scree_attribute kinds[POUR_KINDS];
	int kind_count;
	int poured; // number of places that were chosen so far, whether or not they had room for a body
} Pour;

// Begins to pour. Chooses the attributes of dynamic bodies that have one shape, whose reach is at most four times the
// median reach. If there are no such bodies, kind_count is 0 and nothing is poured.
scree_status pour_begin(Pour* pour, scree_world* world);
void pour_end(Pour* pour);

// Pours bodies around a point (m); call it before a step. Sets *added to true if it creates a body, else leaves it.
scree_status pour_step(Pour* pour, scree_world* world, scree_vec at, bool* added);

// If pouring is on, adds a circle around the area in which bodies are poured.
void pour_mark(const Pour* pour, Strokes* strokes, scree_vec at, float scale);

#endif
