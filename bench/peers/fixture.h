// SPDX-License-Identifier: MIT
// fixture.h -- scenes made by code: bodies held together by joints, some of which come and go between steps.
#ifndef FIXTURE_H
#define FIXTURE_H
#include "scree/scree.h"

#define FIXTURE_PARAMETERS 4

typedef struct
{
	const char* name; // null: none
	double value;     // unless --set gives another
} FixtureParameter;

typedef struct // a world that is being built
{
	scree_world* world;
	const double* values; // values of the parameters
	bool good;            // false after the first failure, which was printed; then nothing more is added
} FixtureBuild;

typedef struct
{
	const char* name;
	int steps; // steps of a trial
	FixtureParameter parameters[FIXTURE_PARAMETERS];
	void (*build)(FixtureBuild* build);
	void (*change)(FixtureBuild* build, int64_t step); // before a step; may be null
} Fixture;

// Sets the parameter of this name. Returns false after printing a sentence.
bool fixture_set(const Fixture* fixture, double values[FIXTURE_PARAMETERS], const char* name, const char* value);

// Surfaces with the usual values. Lengths in m.
scree_attribute_def fixture_box(FixtureBuild* build, float half_width, float half_height);
scree_attribute_def fixture_circle(FixtureBuild* build, float radius);
scree_attribute_def fixture_capsule(FixtureBuild* build, scree_vec a, scree_vec b, float radius);
scree_attribute_def fixture_polygon(FixtureBuild* build, const scree_vec* corners, int count, float radius);

// A definition of a body at a place, not rotated.
scree_body_def fixture_body(scree_body_type type, float x, float y);

scree_body fixture_add(FixtureBuild* build, const scree_body_def* def);
// The same with one collidable, whose filter is that of the definition.
scree_body fixture_put(FixtureBuild* build, scree_body_def def, const scree_attribute_def* surface);
void fixture_attach(FixtureBuild* build, scree_body body, const scree_attribute_def* surface, scree_vec at,
                    scree_filter filter);

void fixture_join(FixtureBuild* build, const scree_joint_def* def);
// A definition of a joint between two points, each in its body's frame; a null body is the world.
scree_joint_def fixture_joint(scree_joint_type type, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b);
void fixture_pin(FixtureBuild* build, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b); // revolute

#endif
