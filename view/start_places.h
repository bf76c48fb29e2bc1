// SPDX-License-Identifier: MIT
// start_places.h -- stores the starting places of bodies, for the paint that colors bodies by starting place.
#ifndef START_PLACES_H
#define START_PLACES_H
#include "scree/scree.h"

typedef struct
{
	scree_vec* places;     // m: starting positions of the bodies, by index
	uint32_t* generations; // generations of the bodies whose places are stored, by body index; 0: no place
	int capacity;
	scree_box box; // box around the points given to starts_frame, without the outermost 0.5 %
} Starts;

// Returns true if the starting place of a body is not stored.
bool starts_misses(const Starts* starts, scree_body body);

// Stores the positions of those bodies that have no stored place. Returns false if memory is short.
bool starts_add(Starts* starts, const scree_body* bodies, const scree_pose* poses, int count);

// Sets Starts.box to a box around these points, without the outermost 0.5 % of the points. Returns false if memory is
// short.
bool starts_frame(Starts* starts, const scree_vec* points, int count);

// Returns the starting place of a body relative to Starts.box: x and y, each from 0 at the lower to 1 at the upper
// side. If no place is stored, returns the center, 0.5 in x and y.
scree_vec starts_share(const Starts* starts, scree_body body);

void starts_close(Starts* starts);

#endif
