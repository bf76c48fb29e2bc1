// SPDX-License-Identifier: MIT
// links.h -- lists the joints of a picture and their paths. The line of a joint leads over both anchors, and ends at
// the origins of dynamic bodies.
#ifndef LINKS_H
#define LINKS_H
#include "scene/sprites.h"

typedef struct // joint to draw
{
	scree_joint joint;
	int bodies[2];        // index in Sprites.bodies, -1 for the world
	bool centers[2];      // true if the line ends at the body's origin, not at the anchor
	scree_vec anchors[2]; // m, in the bodies' frames or in the world
	bool roped;           // true if the line between the anchors goes over the bases of a pulley
	bool railed;          // true for a joint on a path, whose line has only the anchor of body b
	scree_vec bases[2];   // m, in the world: bases of a pulley
} Link;

typedef struct // path to draw, on a body or in the world
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

// Lists the joints of a world, except filter joints and disabled joints. Returns false if memory is short.
bool links_list(Links* links, const Sprites* sprites, scree_world* world);
void links_free(Links* links);

#define LINK_POINTS 6

// Writes the points of a joint's line in the world, at least 1 and at most LINK_POINTS, and the positions of both
// anchors in the list of points. Returns the number of points.
int link_points(const Link* link, const scree_pose* poses, scree_vec points[LINK_POINTS], int anchors[2]);

// Returns point k of a drawn path, in the world.
scree_vec rail_point(const Rail* rail, const scree_pose* poses, int k);

#endif
