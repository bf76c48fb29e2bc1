// SPDX-License-Identifier: MIT
// grab.h -- what the cursor does to bodies: picks one, drags it, throws new bodies in.
#ifndef GRAB_H
#define GRAB_H
#include "view/render_tables.h"

// what a Grab of zeros has: such a spring pulls, and does not push a body through others
#define GRAB_HARDEST 1000.0f
#define GRAB_HERTZ   5.0f
#define GRAB_DENSITY 1.0f

typedef struct
{
	scree_world* world;
	scree_joint joint;         // by which the cursor holds a body; null for none
	scree_body body;           // that it holds
	scree_vec anchor;          // where the cursor holds it, in the body's frame, m
	scree_vec at;              // the cursor, m
	scree_vec velocity;        // of the cursor, smoothed, m/s
	int launched;              // bodies thrown in so far
	scree_attribute thrown[3]; // ball, box, capsule: made once for a size
	float thrown_size;         // m
	float thrown_density;      // kg/m^2
	float hardest;             // m/s^2 that the spring between cursor and body gives at most, along each axis
	float hertz;               // of that spring
	float density;             // kg/m^2 of what is thrown in
} Grab;

// Finds the dynamic body under the cursor, and where on it the cursor is, and does nothing to it; false when there is none.
bool grab_reach(Grab* grab, const RenderTables* tables);

// Picks the dynamic body under the cursor; false when there is none.
bool grab_pick(Grab* grab, const RenderTables* tables);
void grab_release(Grab* grab);
bool grab_holds(const Grab* grab);

// Moves the cursor to a point; seconds: since it was at the last one.
void grab_move(Grab* grab, scree_vec to, double seconds);

// Moves the target of the joint to the cursor. Fails if the body was destroyed.
scree_status grab_pull(Grab* grab);

// Where the body is held, m.
scree_status grab_anchor(Grab* grab, scree_vec* anchor);

// Adds a body of about this size in metres at the cursor, with the cursor's velocity: a ball, a box and a capsule in turn.
scree_status grab_launch(Grab* grab, float size);

#endif
