// SPDX-License-Identifier: MIT
// ruler.h -- measures overlaps and contacts of poses, in the same way for all engines.
#ifndef RULER_H
#define RULER_H
#include "scene/scene.h"

typedef struct
{
	scree_world* world; // with the bodies of the scene, at the poses of the engine
	scree_body* bodies;
	scree_velocity* still; // zeros
	int count;
	scree_pose* poses; // of the engine; the caller fills them before measuring

	int measured;
	float penetration; // deepest so far, m
	double depths;     // sum of the deepest of each measurement, m
	double contacts;   // sum of the touching contacts of each
	float* height;     // of each body at the first measurement, m
	float sunk;        // largest distance that a body has sunk since the first measurement, m
} Ruler;

// Both return false after printing a sentence. The caller closes the ruler also then.
bool ruler_open(Ruler* ruler, const Scene* scene);
bool ruler_measure(Ruler* ruler);
void ruler_close(Ruler* ruler);

#endif
