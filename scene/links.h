// SPDX-License-Identifier: MIT
// links.h -- the joints of a picture: a line from the center of one body over the anchors to the center of the other.
#ifndef LINKS_H
#define LINKS_H
#include "scene/sprites.h"

typedef struct // one joint to draw
{
	scree_joint joint;
	int bodies[2];        // index in Sprites.bodies, -1 for the world
	bool centers[2];      // true if the line continues to the body's origin
	scree_vec anchors[2]; // m, in the bodies' frames or in the world
	bool roped;           // true if the line between the anchors goes over the bases of a pulley
	bool railed;          // true if it is on a path, and has only the anchor of b
	scree_vec bases[2];   // m, in the world
} Link;

typedef struct // a path to draw, in a body or in the world
{
	scree_path path;
	int body;          // index in Sprites.bodies, -1 for the world
	scree_pose frame;  // frame of the path
	scree_vec* points; // m, in the body's frame or in the world
	int count;
} Rail;

typedef struct
{
	Link* list;
	int count;
	Rail* rails;
	int rail_count;
} Links;

// Lists the joints of a world that hold or move something. Returns false if memory is short.
bool links_list(Links* links, const Sprites* sprites, scree_world* world);
void links_free(Links* links);

#define LINK_POINTS 6

// Writes the 1 to LINK_POINTS points of the line in the world, and the positions of both anchors among them; returns
// the count of points.
int link_points(const Link* link, const scree_pose* poses, scree_vec points[LINK_POINTS], int anchors[2]);

// Returns point k of a path in the world.
scree_vec rail_point(const Rail* rail, const scree_pose* poses, int k);

#endif
