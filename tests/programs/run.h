// SPDX-License-Identifier: MIT
// run.h -- one call of a program on one world.
#ifndef RUN_H
#define RUN_H
#include "programs/program.h"

// numbers that a program may give out
#define MOST_NAMES 8192

struct Names
{
	scree_body bodies[MOST_NAMES];
	scree_collidable collidables[MOST_NAMES];
	scree_attribute attributes[MOST_NAMES];
};

typedef struct // what a call left
{
	scree_status status;
	uint64_t word; // of what it read
	char error[256];
} Left;

typedef struct // a call on one of the worlds
{
	const Call* call;
	scree_world* world;
	struct Names* names;
	const Place* place;
	const char* home; // where the world was made
	Left* left;
} Turn;

// Makes the call and returns its status; left gets what it read.
scree_status run_call(const Turn* turn);

// Makes the world that a program begins with.
scree_status run_world(const Place* place, const Call* call, scree_world** world);

#endif
