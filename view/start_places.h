// SPDX-License-Identifier: MIT
// start_places.h -- where bodies began, for the paint by starting place.
#ifndef START_PLACES_H
#define START_PLACES_H
#include "scree/scree.h"

typedef struct
{
	scree_vec* places;     // m, by the index of a body
	uint32_t* generations; // of the bodies whose places they are; 0 for none
	int capacity;
	scree_box box; // around the places that were added first, but for the outermost 0.5 %
} Starts;

// Whether a body's place is missing.
bool starts_misses(const Starts* starts, scree_body body);

// Adds the places of the bodies that are missing. False when memory is short.
bool starts_add(Starts* starts, const scree_body* bodies, const scree_pose* poses, int count);

// Makes the box the one around these points.
bool starts_frame(Starts* starts, const scree_vec* points, int count);

// Where a body began within the box, 0 to 1 in x and y.
scree_vec starts_share(const Starts* starts, scree_body body);

void starts_close(Starts* starts);

#endif
