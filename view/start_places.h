// SPDX-License-Identifier: MIT
// start_places.h -- stores the starting places of bodies, for the paint by starting place.
#ifndef START_PLACES_H
#define START_PLACES_H
#include "scree/scree.h"

typedef struct
{
	scree_vec* places;     // m: positions by body index
	uint32_t* generations; // generations of the bodies whose places are stored, by body index; 0: no place
	int capacity;
	scree_box box; // box around the places at starts_frame, without the outermost 0.5 %
} Starts;

// Returns true if no starting place of a body is stored.
bool starts_misses(const Starts* starts, scree_body body);

// Stores the positions of bodies without a stored place. Returns false if memory is short.
bool starts_add(Starts* starts, const scree_body* bodies, const scree_pose* poses, int count);

// Sets box to a box around these points, without the outermost 0.5 %. Returns false if memory is short.
bool starts_frame(Starts* starts, const scree_vec* points, int count);

// Returns the position of a body's starting place in box: 0 to 1 in x and y. If no place is stored, returns the middle.
scree_vec starts_share(const Starts* starts, scree_body body);

void starts_close(Starts* starts);

#endif
