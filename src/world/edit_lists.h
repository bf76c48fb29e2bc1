// SPDX-License-Identifier: MIT
// edit_lists.h -- declares the lists of changes since the last upload: rows, then commands in the order of the calls.
#ifndef EDIT_LISTS_H
#define EDIT_LISTS_H
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>

typedef struct // row of a created or destroyed body; if destroyed, values are 0 and the rotation is (1, 0)
{
	int index;       // first in the struct (edit_order.c)
	int since;       // number of commands recorded before this row; they belong to the previous body in the slot
	scree_pose pose; // pose of the origin
	scree_vec center;
	scree_velocity velocity;
	BodyValues values;
	float inv_mass, inv_inertia;
	uint32_t locks;
	float sleep_threshold; // value of the pool sleep_threshold
	bool asleep;
	bool disabled;
} BodyRow;

typedef struct // row of a created or destroyed collidable; the upload reads the values from HostCollidable
{
	int index; // as BodyRow.index
	int since; // as BodyRow.since
} CollidableRow;

typedef struct // pending edits of a body or a collidable; zeros if there are none
{
	int row;   // 1 + index of its row in Edits.bodies or Edits.collidables
	int group; // 1 + index of its group of commands; set during world_upload
} PendingEdits;

typedef struct
{
	BodyRow* bodies;
	CollidableRow* collidables;
	Command* commands;
	int body_count, body_capacity;
	int collidable_count, collidable_capacity;
	int command_count, command_capacity;
	int* attributes; // slots of attributes to upload, each once
	int attribute_count, attribute_capacity;
	int* joints; // slots of joints to upload, each once
	int joint_count, joint_capacity;
	int* paths; // slots of paths to upload, each once
	int path_count, path_capacity;
	int sample_rows;    // 1 + highest row of the pool path_sample that was ever written
	int attribute_rows; // 1 + highest row of the pool attribute that was ever written
} Edits;

#endif
