// SPDX-License-Identifier: MIT
// inspect.h -- what lies under the cursor or was selected, in numbers.
#ifndef INSPECT_H
#define INSPECT_H
#include "scene/scene.h"
#include "view/stroke.h"

typedef struct
{
	scree_collidable collidable; // null: nothing
	scree_body body;             // of it; null for none
	char name[64];               // as the scene calls it
	bool gone;                   // it was destroyed; the numbers are the last ones

	scree_body_type type; // and what follows up to contacts: of a body
	bool enabled;
	scree_velocity velocity;
	scree_mass mass;
	int contacts; // of the body
	float force;  // N: sum of the normal forces of its contacts, of the first CONTACTS of many
	int joints;   // of the body
	float linear_damping, angular_damping, gravity_scale;
	int shapes;             // collidables of the body
	scree_pose pose;        // of the body, or of the collidable
	uint32_t sees, reports; // bits of a sensor, of reports
	int visits;             // that last, to a sensor
	scree_filter filter;
	scree_attribute_def attribute;
} Inspected;

// The collidable under a point, within a radius (m): of several the one that is drawn on top, and sensors only if there is
// nothing else. Null for none. One query; the world does not change.
scree_status inspect_find(scree_world* world, scree_vec at, float radius, scree_collidable* found);

// Begins to inspect a collidable; null ends it.
void inspect_choose(Inspected* inspected, const Scene* scene, const scree_world* world, scree_collidable collidable);

// Reads the numbers; the scene made the world. What was destroyed is marked as gone.
scree_status inspect_read(Inspected* inspected, const Scene* scene, scree_world* world);

// Where the body is, m. False if there is none.
bool inspect_place(const Inspected* inspected, scree_world* world, scree_vec* at);

bool inspect_any(const Inspected* inspected);

// Adds the outlines of all shapes of the body, where it is now.
void inspect_mark(const Inspected* inspected, scree_world* world, Strokes* strokes, const Camera* camera, bool dark);

#endif
