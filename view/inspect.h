// SPDX-License-Identifier: MIT
// inspect.h -- reads the numbers of the collidable that is under the cursor or selected.
#ifndef INSPECT_H
#define INSPECT_H
#include "scene/scene.h"
#include "view/stroke.h"

typedef struct
{
	scree_collidable collidable; // null: nothing is inspected
	scree_body body;             // body of the collidable; null if the collidable has no body
	char name[64];               // text such as "brick 3" or "stone of body 12", from names in the scene
	bool gone;                   // true if the collidable was destroyed; the numbers are those of the last reading

	scree_body_def def; // the members from `def` to `shapes` are valid if there is a body
	scree_mass mass;
	int contacts;           // number of contacts of the body
	float force;            // N: sum of the normal forces of at most CONTACTS contacts of the body
	int joints;             // number of joints of the body
	int shapes;             // number of collidables of the body
	scree_pose pose;        // pose of the body; of the collidable if it has no body
	uint32_t sees, reports; // results of scree_collidable_get_sensor and scree_collidable_get_reports
	int visits;             // number of current visits, if the collidable is a sensor
	scree_filter filter;
	scree_attribute_def attribute;
} Inspected;

// Sets *found to the collidable within a radius (m) of a point, or to null. If several are within the radius, chooses
// the one that is drawn over the others, and a sensor only if there is nothing else. Makes one query; the world does
// not change.
scree_status inspect_find(scree_world* world, scree_vec at, float radius, scree_collidable* found);

// Starts to inspect a collidable; null: stops inspecting.
void inspect_choose(Inspected* inspected, const Scene* scene, const scree_world* world, scree_collidable collidable);

// Reads the numbers of the inspected collidable; `scene` is the scene of the world. If the collidable was destroyed,
// only sets Inspected.gone.
scree_status inspect_read(Inspected* inspected, const Scene* scene, scree_world* world);

// Sets *at to the position of the inspected body, m. Returns false if there is no body.
bool inspect_place(const Inspected* inspected, scree_world* world, scree_vec* at);

bool inspect_any(const Inspected* inspected);

// Adds the outlines of all shapes of the body (of the collidable, if it has no body) at the current pose.
void inspect_mark(const Inspected* inspected, scree_world* world, Strokes* strokes, const Camera* camera, bool dark);

#endif
