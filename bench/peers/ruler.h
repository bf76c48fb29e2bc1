// SPDX-License-Identifier: MIT
// ruler.h -- overlaps and contacts of a set of poses, measured by one rule whichever engine they come from.
#ifndef RULER_H
#define RULER_H
#include "scene/scene.h"

typedef struct
{
	scree_world* world; // with the bodies of the scene, put where the engine has them
	scree_body* bodies;
	scree_velocity* still; // zeros
	int count;
	scree_pose* poses; // what the engine says, to be filled in before measuring

	int measured;
	float penetration; // deepest so far, m
	double depths;     // sum of the deepest of each measurement, m
	double contacts;   // sum of the touching contacts of each
	float* height;     // of each body at the first measurement, m
	float sunk;        // at the last measurement: how far the body that sank most is below its first height, m
} Ruler;

// Both return false after printing what is wrong; close also then.
bool ruler_open(Ruler* ruler, const Scene* scene);
bool ruler_measure(Ruler* ruler);
void ruler_close(Ruler* ruler);

#endif
