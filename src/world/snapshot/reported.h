// SPDX-License-Identifier: MIT
// reported.h -- keeps the poses that the user has read last (scree_world_get_moved_bodies) while a world goes back to another
// state: the list is about the program that reads it, so no load or restore turns it back.
#ifndef REPORTED_H
#define REPORTED_H
#include "world/world.h"

typedef struct // copy of the poses that the user has read, during a load
{
	uint32_t* generation; // generations of the bodies; null if the load changes none
	int bodies, used;     // numbers of items in the pools, and of slots
	int at;               // first item of the copy in the pool `saved`
	float unit;           // length_unit
} Reported;

// Returns the number of items of the pool `saved` for a copy; 0 if the user has read no list.
int reported_items(const scree_world* world);

// Copies what the user has read to the pool `saved`, from item r->at on. same: the load changes no body. On failure too,
// reported_close must follow.
scree_status reported_take(scree_world* world, const char* function, bool same, Reported* r);
// Copies it back. The pose of a body that the world had not at reported_take is 0, so that it is listed as a new one; so are all
// poses if the unit of length is another one.
scree_status reported_return(scree_world* world, const Reported* r);
void reported_close(Reported* r);

// Replaces the poses of a snapshot, items of the pools of the world `made`, by what the user has read of the world that it will
// replace. poses: null if `made` has no bodies.
scree_status reported_keep(scree_world* world, scree_world* made, Float4* poses, int* sleeps);

#endif
