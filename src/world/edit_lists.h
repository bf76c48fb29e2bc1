// SPDX-License-Identifier: MIT
// edit_lists.h -- the user's changes since the last upload: new rows, then commands in the order of calls.
#ifndef EDIT_LISTS_H
#define EDIT_LISTS_H
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>

typedef struct // row of a body; for a destroyed body all zero except the rotation
{
	int index;
	int since;       // commands before this one belong to the previous body of the slot
	scree_pose pose; // pose of the origin
	scree_vec center;
	scree_velocity velocity;
	float inv_mass, inv_inertia;
	BodyValues values;
	uint32_t locks;
	bool disabled;
} BodyRow;

typedef struct // row of a collidable; the upload reads its values from the host
{
	int index;
	int since; // see BodyRow
} CollidableRow;

typedef struct // pending edits of a body or a collidable; 0 for none
{
	int row;   // 1 + index of its row
	int group; // 1 + its group of commands, during world_upload
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
	int* joints; // the same for joints
	int joint_count, joint_capacity;
	int* paths; // the same for paths
	int path_count, path_capacity;
	int sample_rows;    // number of path samples on the device that have ever been written
	int attribute_rows; // number of attribute rows on the device that have ever been written
} Edits;

#endif
