// SPDX-License-Identifier: MIT
// fingerprint.h -- computes the hash of what no step of a world changes: its structure, and the settings of a step.
#ifndef FINGERPRINT_H
#define FINGERPRINT_H
#include "batch/template.h"

// Returns the hash. The image has the numbers of attributes of the world alone (before template_shift).
uint64_t fingerprint_of(const Template* from);

typedef struct // the structure of a body
{
	Float2 local_center;
	ContinuousBody continuous;
	float sleep_threshold, inv_mass, inv_inertia;
	BodyValues values;
	float free_x, free_y;
} BodyStructure;

typedef struct // the structure of a collidable; zeros if the slot is free
{
	Float4 pose;
	Word64 category, mask;
	int kind, body, attribute, next, group; // attribute: number in the world alone
	Word reports;
} CollidableStructure;

typedef struct // the structure of a joint, without the values that inputs of a batch change; zeros if there is none
{
	JointData data;
	int flags;
} JointStructure;

// Set the structure of an item of the image, with zeros as padding.
void body_structure(const Template* from, int i, BodyStructure* to);
void collidable_structure(const Template* from, int i, CollidableStructure* to);
void joint_structure(const Template* from, int i, JointStructure* to);

#endif
