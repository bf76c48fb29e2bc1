// SPDX-License-Identifier: MIT
// inspect.h -- the numbers of the collidable that is under the cursor or selected.
#ifndef INSPECT_H
#define INSPECT_H
#include "scene/scene.h"
#include "view/stroke.h"

typedef struct
{
	scree_collidable collidable; // null: nothing is inspected
	scree_body body;             // body of the collidable; null if it has none
	char name[64];               // name in the scene
	bool gone;                   // true if it was destroyed; the numbers are the last ones

	scree_body_def def; // valid if there is a body, as are the members below, up to shapes
	scree_mass mass;
	int contacts;           // number of contacts of the body
	float force;            // N: sum of the normal forces of its contacts, but of at most CONTACTS of them
	int joints;             // number of joints of the body
	int shapes;             // number of collidables of the body
	scree_pose pose;        // pose of the body, or of the collidable
	uint32_t sees, reports; // bits of the sensor, of the reports
	int visits;             // number of current visits to a sensor
	scree_filter filter;
	scree_attribute_def attribute;
} Inspected;

// Finds the collidable within a radius (m) of a point, null if there is none: among several the one that is drawn on
// top, a sensor only if there is nothing else. Makes one query; the world does not change.
scree_status inspect_find(scree_world* world, scree_vec at, float radius, scree_collidable* found);

// Starts to inspect a collidable; null stops it.
void inspect_choose(Inspected* inspected, const Scene* scene, const scree_world* world, scree_collidable collidable);

// Reads the numbers. scene is the scene of the world. Sets gone if the collidable was destroyed.
scree_status inspect_read(Inspected* inspected, const Scene* scene, scree_world* world);

// Returns the position of the body, m; false if there is none.
bool inspect_place(const Inspected* inspected, scree_world* world, scree_vec* at);

bool inspect_any(const Inspected* inspected);

// Adds the outlines of all shapes of the body at its current pose.
void inspect_mark(const Inspected* inspected, scree_world* world, Strokes* strokes, const Camera* camera, bool dark);

#endif
