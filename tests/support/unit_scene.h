// SPDX-License-Identifier: MIT
// unit_scene.h -- builds a scene with every kind of object in any unit of length, and reads all results of its world in metres.
#ifndef UNIT_SCENE_H
#define UNIT_SCENE_H
#include "support/checks.h"

typedef struct // a world and the objects that the test uses
{
	scree_world* world;
	float u; // units per metre
	scree_attribute box, ball;
	scree_body crates[6], ball_body, lift, wheels[2];
	scree_joint hinge, gear, rack, bead, spring;
	scree_path path;
	scree_field fields[4];
	scree_collidable sensor;
	scree_mover mover;
	scree_body follower; // kinematic body of the mover
} UnitScene;

// Opens a world on a device with a unit of length, and builds the scene. Each length is multiplied by the power of the unit that
// physics gives it, written out here independently of the library's lists. lanes: 0 or a number that this build or processor lacks:
// the widest.
void unit_scene_open(UnitScene* s, const char* device, int lanes, float unit);

// Calls of one step: forces, impulses, targets, motors, a blast and the mover; then the step.
void unit_scene_step(UnitScene* s, int step);

#define UNIT_RESULTS 4096

// Writes all results of the world, each divided by its power of the unit. Returns their number, at most UNIT_RESULTS.
int unit_scene_results(UnitScene* s, float* results);

#endif
