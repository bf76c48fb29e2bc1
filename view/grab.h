// SPDX-License-Identifier: MIT
// grab.h -- the cursor as a tool on bodies: it picks one, drags it, throws new bodies in.
#ifndef GRAB_H
#define GRAB_H
#include "view/render_tables.h"

// defaults, used where a Grab has 0: such a spring pulls a body, but does not push it through others
#define GRAB_HARDEST 1000.0f
#define GRAB_HERTZ   5.0f
#define GRAB_DENSITY 1.0f

typedef struct
{
	scree_world* world;
	scree_joint joint;         // joint by which the cursor holds a body; null if there is none
	scree_body body;           // body that the cursor holds
	scree_vec anchor;          // point of the body at which the cursor holds it, in the body's frame, m
	scree_vec at;              // position of the cursor, m
	scree_vec velocity;        // velocity of the cursor, smoothed, m/s
	int launched;              // number of bodies thrown in so far
	scree_attribute thrown[3]; // ball, box, capsule: created once per size and density
	float thrown_size;         // m
	float thrown_density;      // kg/m^2
	float hardest;             // maximum acceleration by the spring between cursor and body, m/s^2, along each axis
	float hertz;               // frequency of that spring, Hz
	float density;             // density of bodies that are thrown in, kg/m^2
} Grab;

// Finds the dynamic body under the cursor and the cursor's point on it, without holding it. Returns false if there is
// none.
bool grab_reach(Grab* grab, const RenderTables* tables);

// Picks the dynamic body under the cursor. Returns false if there is none.
bool grab_pick(Grab* grab, const RenderTables* tables);
void grab_release(Grab* grab);
bool grab_holds(const Grab* grab);

// Moves the cursor to a point; seconds is the time since its last move.
void grab_move(Grab* grab, scree_vec to, double seconds);

// Moves the target of the joint to the cursor. Fails if the body was destroyed.
scree_status grab_pull(Grab* grab);

// Returns the point of the world where the body is held, m.
scree_status grab_anchor(Grab* grab, scree_vec* anchor);

// Adds a body of about this size (m) at the cursor, with the cursor's velocity: a ball, a box and a capsule in turn.
scree_status grab_launch(Grab* grab, float size);

#endif
