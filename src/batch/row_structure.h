// SPDX-License-Identifier: MIT
// row_structure.h -- reads the structure of items: what neither steps nor inputs change, or what follows from own values.
#ifndef ROW_STRUCTURE_H
#define ROW_STRUCTURE_H
#include "batch/own_host.h"

typedef struct // the structure of a body
{
	Float2 local_center;
	ContinuousBody continuous;
	float sleep_threshold, inv_mass, inv_inertia;
	BodyValues values;
	float free_x, free_y;
} BodyStructure;

typedef struct // the structure of a collidable; zeros if it is dead
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

// Set the structure of an item of pools, with zeros as padding. first_attribute: number of the first attribute of the world.
void body_structure(const Pools* pools, int i, BodyStructure* to);
void collidable_structure(const Pools* pools, int i, int first_attribute, CollidableStructure* to);
void joint_structure(const Pools* pools, int i, JointStructure* to);

typedef struct // the world whose structure is expected
{
	const Template* from;
	scree_world* host; // host data with the own values; null: the world has those of its template
	Own own;           // if there is a host
} Expected;

// Set the structure that an item must have.
void expected_body(const Expected* e, int i, BodyStructure* to);
void expected_collidable(const Expected* e, int i, CollidableStructure* to);
void expected_joint(const Expected* e, int i, JointStructure* to);

#endif
