// SPDX-License-Identifier: MIT
// fixture.h -- declares fixtures: scenes made by code, most of them with joints, some with bodies that are created and
// destroyed between steps.
#ifndef FIXTURE_H
#define FIXTURE_H
#include "scree/scree.h"

#define FIXTURE_PARAMETERS 4

typedef struct
{
	const char* name; // null at the end of the list
	double value;     // default value, used unless --set gives another
} FixtureParameter;

typedef struct // a world that is being built
{
	scree_world* world;
	const double* values; // values of the parameters
	bool good;            // false after the first failure, which was printed; later calls then add nothing
} FixtureBuild;

typedef struct
{
	const char* name;
	int steps; // number of steps of a trial
	FixtureParameter parameters[FIXTURE_PARAMETERS];
	void (*build)(FixtureBuild* build);
	void (*change)(FixtureBuild* build, int64_t step); // changes bodies before a step; null: no changes
} Fixture;

// Sets the parameter of this name. If the name or the value is wrong, prints a sentence and returns false.
bool fixture_set(const Fixture* fixture, double values[FIXTURE_PARAMETERS], const char* name, const char* value);

// Return the definition of an attribute with a shape and default values. Lengths in m.
scree_attribute_def fixture_box(FixtureBuild* build, float half_width, float half_height);
scree_attribute_def fixture_circle(FixtureBuild* build, float radius);
scree_attribute_def fixture_capsule(FixtureBuild* build, scree_vec a, scree_vec b, float radius);
scree_attribute_def fixture_polygon(FixtureBuild* build, const scree_vec* corners, int count, float radius);

// Returns the definition of a body at a place (m), not rotated.
scree_body_def fixture_body(scree_body_type type, float x, float y);

// Adds a body and returns its handle.
scree_body fixture_add(FixtureBuild* build, const scree_body_def* def);
// Adds a body with one collidable at its origin, and returns the handle of the body. The collidable gets def.filter.
scree_body fixture_put(FixtureBuild* build, scree_body_def def, const scree_attribute_def* surface);
// Adds a collidable to a body. at: position of the collidable in the body's frame, m.
void fixture_attach(FixtureBuild* build, scree_body body, const scree_attribute_def* surface, scree_vec at,
                    scree_filter filter);

void fixture_join(FixtureBuild* build, const scree_joint_def* def);
// Returns the definition of a joint between two points (m), each in its body's frame; a null body is the world.
scree_joint_def fixture_joint(scree_joint_type type, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b);
// Adds a revolute joint between two points.
void fixture_pin(FixtureBuild* build, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b);

#endif
