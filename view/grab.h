// SPDX-License-Identifier: MIT
// grab.h -- tools at the cursor: picks and drags a body, throws new bodies into the world.
#ifndef GRAB_H
#define GRAB_H
#include "view/render_tables.h"

// Default values for members of Grab that are 0. With these values the spring pulls a body, but does not push it
// through other bodies.
#define GRAB_HARDEST 1000.0f
#define GRAB_HERTZ   5.0f
#define GRAB_DENSITY 1.0f

typedef struct
{
	scree_world* world;
	scree_joint joint;         // joint by which the cursor holds a body; null if there is none
	scree_body body;           // body that the cursor holds
	scree_vec anchor;          // m: point at which the cursor holds the body, in the body's frame
	scree_vec at;              // position of the cursor, m
	scree_vec velocity;        // velocity of the cursor, smoothed, m/s
	int launched;              // number of bodies thrown so far
	scree_attribute thrown[3]; // attributes of ball, box, capsule; created again if size or density changes
	float thrown_size;         // m: radius of the ball in `thrown`
	float thrown_density;      // kg/m^2: density of the attributes in `thrown`
	float hardest;             // m/s^2: maximum acceleration along each axis by the spring between cursor and body
	float hertz;               // frequency of the spring between cursor and body, Hz
	float density;             // density of thrown bodies, kg/m^2
} Grab;

// Finds the dynamic body under the cursor; sets Grab.body and Grab.anchor, but does not create a joint. Returns false
// if there is no such body.
bool grab_reach(Grab* grab, const RenderTables* tables);

// Finds the dynamic body under the cursor, and creates the joint that holds it. Returns false if there is no such body.
bool grab_pick(Grab* grab, const RenderTables* tables);
void grab_release(Grab* grab);
bool grab_holds(const Grab* grab);

// Moves the cursor to a point; seconds: time since the previous move of the cursor.
void grab_move(Grab* grab, scree_vec to, double seconds);

// Moves the target of the joint to the cursor. Returns an error if the body was destroyed.
scree_status grab_pull(Grab* grab);

// Sets *anchor to the current position of the point at which the body is held, m.
scree_status grab_anchor(Grab* grab, scree_vec* anchor);

// Adds a body with a size of about `size`, m, at the cursor, with the velocity of the cursor. Successive calls add a
// ball, a box and a capsule in turn.
scree_status grab_launch(Grab* grab, float size);

#endif
