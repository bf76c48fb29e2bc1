// SPDX-License-Identifier: MIT
// edit_lists.h -- what the user changed since the last upload: new rows, then commands in the order of calls.
#ifndef EDIT_LISTS_H
#define EDIT_LISTS_H
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>

typedef struct // the row of a body; all zero but the rotation for a body that was destroyed
{
	int index;
	int since;       // commands before this one belong to what the slot held before
	scree_pose pose; // of the origin
	scree_vec center;
	scree_velocity velocity;
	float inv_mass, inv_inertia;
	float gravity_scale, linear_damping, angular_damping;
	uint32_t locks;
	bool disabled;
} BodyRow;

typedef struct // the row of a collidable; its values are taken from the host at the upload
{
	int index;
	int since; // as in BodyRow
} CollidableRow;

typedef struct // kept with a body or a collidable; 0 for none
{
	int row;   // 1 + its place among the rows
	int group; // 1 + its group of commands, within world_upload
} PendingEdits;

typedef struct
{
	BodyRow* bodies;
	CollidableRow* collidables;
	Command* commands;
	int body_count, body_capacity;
	int collidable_count, collidable_capacity;
	int command_count, command_capacity;
	int* attributes; // slots to upload, each once
	int attribute_count, attribute_capacity;
	int* joints; // the same
	int joint_count, joint_capacity;
	int* paths; // the same
	int path_count, path_capacity;
	int sample_rows;    // samples of paths of the device that have ever been written
	int attribute_rows; // rows of the device that have ever been written
} Edits;

#endif
