// SPDX-License-Identifier: MIT
// fixture.h -- scenes made by code: bodies held together by joints, some of which come and go between steps.
#ifndef FIXTURE_H
#define FIXTURE_H
#include "scree/scree.h"

#define RIG_PARAMETERS 4

typedef struct
{
	const char* name; // null: none
	double value;     // unless --set gives another
} RigParameter;

typedef struct // a world that is being built
{
	scree_world* world;
	const double* values; // of the parameters
	bool good;            // false after the first failure, which was printed; then nothing more is added
} RigBuild;

typedef struct
{
	const char* name;
	int steps; // of a trial
	RigParameter parameters[RIG_PARAMETERS];
	void (*build)(RigBuild* build);
	void (*change)(RigBuild* build, int64_t step); // before a step; may be null
} Rig;

// The rig of this name, or null.
const Rig* rig_find(const char* name);

// Sets the parameter of this name. Returns false after printing a sentence.
bool rig_set(const Rig* rig, double values[RIG_PARAMETERS], const char* name, const char* value);

// Surfaces with the usual values. Lengths in m.
scree_attribute_def rig_box(RigBuild* build, float half_width, float half_height);
scree_attribute_def rig_circle(RigBuild* build, float radius);
scree_attribute_def rig_capsule(RigBuild* build, scree_vec a, scree_vec b, float radius);
scree_attribute_def rig_polygon(RigBuild* build, const scree_vec* corners, int count, float radius);

// A definition of a body at a place, not rotated.
scree_body_def rig_body(scree_body_type type, float x, float y);

scree_body rig_add(RigBuild* build, const scree_body_def* def);
// The same with one collidable, whose filter is that of the definition.
scree_body rig_put(RigBuild* build, scree_body_def def, const scree_attribute_def* surface);
void rig_attach(RigBuild* build, scree_body body, const scree_attribute_def* surface, scree_vec at,
                scree_filter filter);

void rig_join(RigBuild* build, const scree_joint_def* def);
// A definition of a joint between two points, each in its body's frame; a null body is the world.
scree_joint_def rig_joint(scree_joint_type type, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b);
void rig_pin(RigBuild* build, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b); // revolute

#endif
