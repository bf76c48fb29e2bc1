// SPDX-License-Identifier: MIT
// edits.h -- what the user changed since the device was last told: rows made anew, then commands in the order of calls.
//
// A row is what a body is at the moment it is made, and every later change is a command, so that it does not matter
// when the device is told. The row of a collidable holds nothing that the host does not know, and is taken from there.
#ifndef PENDING_H
#define PENDING_H
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>

typedef struct // the row of a body, sorted by index; all zero but the rotation for one that is destroyed
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

typedef struct // the row of a collidable, the same
{
	int index;
	int since;
} CollidableRow;

typedef struct // kept with a body or a collidable; 0 for none
{
	int row;   // 1 + its place among the rows
	int group; // 1 + its group of commands, within world_upload
} Waiting;

typedef struct
{
	BodyRow* bodies;
	CollidableRow* collidables;
	Command* commands;
	int body_count, body_capacity;
	int collidable_count, collidable_capacity;
	int command_count, command_capacity;
	int* attributes; // slots that the device has to hear of, each once
	int attribute_count, attribute_capacity;
	int attribute_rows; // of the device, that have ever been written
} Edits;

// Room for so many more, after which the functions below cannot fail.
scree_status edits_reserve(scree_world* world, const char* function, int bodies, int collidables, int commands);
void edits_close(Edits* pending);

// A body was made or destroyed. Its row's index and what it is are given; since is filled in.
void edits_body(scree_world* world, BodyRow row);

// A collidable was made, destroyed, or has to start anew.
void edits_collidable(scree_world* world, int index);

// A change; whole is Command.whole[0].
void edits_command(scree_world* world, int kind, int index, Float4 value, int whole);
void edits_whole(scree_world* world, Command command);

#endif
