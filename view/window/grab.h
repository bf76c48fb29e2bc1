// SPDX-License-Identifier: MIT
// grab.h -- what the cursor does to bodies: picks one, drags it, throws new ones in.
#ifndef HAND_H
#define HAND_H
#include "view/look.h"

typedef struct
{
	scree_world* world;
	scree_body body;           // that it holds; null for none
	scree_mass mass;           // of the body
	scree_vec anchor;          // where it holds it, in the body's frame, m
	scree_vec at;              // the cursor, m
	scree_vec velocity;        // of the cursor, smoothed, m/s
	int launched;              // bodies thrown in so far
	scree_attribute thrown[3]; // what they are: made once for a size
	float thrown_size;         // m
} Hand;

// Takes hold of the dynamic body under the cursor; false when there is none.
bool hand_pick(Hand* hand, const Look* look);
void hand_release(Hand* hand);
bool hand_holds(const Hand* hand);

// The cursor is at a point, so many seconds after it was at the last one.
void hand_move(Hand* hand, scree_vec to, double seconds);

// Pulls the body towards the cursor during the next step.
scree_status hand_pull(Hand* hand);

// Where the body is held, m.
scree_status hand_anchor(Hand* hand, scree_vec* anchor);

// Throws a body of about so many metres in at the cursor: a ball, a box or a capsule, as fast as the cursor moves.
scree_status hand_launch(Hand* hand, float size);

#endif
