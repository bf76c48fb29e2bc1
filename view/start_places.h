// SPDX-License-Identifier: MIT
// start_places.h -- starting places of bodies, for the paint by starting place.
#ifndef START_PLACES_H
#define START_PLACES_H
#include "scree/scree.h"

typedef struct
{
	scree_vec* places;     // m, by body index
	uint32_t* generations; // generations of the bodies whose places are stored; 0: none
	int capacity;
	scree_box box; // box around the places that were added first, without the outermost 0.5 %
} Starts;

// Returns true if the place of a body is not stored.
bool starts_misses(const Starts* starts, scree_body body);

// Stores the places of bodies that have none yet. Returns false if memory is short.
bool starts_add(Starts* starts, const scree_body* bodies, const scree_pose* poses, int count);

// Sets the box to one around these points.
bool starts_frame(Starts* starts, const scree_vec* points, int count);

// Returns the starting place of a body within the box, 0 to 1 in x and y.
scree_vec starts_share(const Starts* starts, scree_body body);

void starts_close(Starts* starts);

#endif
