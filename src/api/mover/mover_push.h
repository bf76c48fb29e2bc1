// SPDX-License-Identifier: MIT
// mover_push.h -- computes the impulses with which movers push the dynamic bodies that they walk against.
#ifndef MOVER_PUSH_H
#define MOVER_PUSH_H
#include "scree/scree.h"

typedef struct // movers of one call, before and after their motion
{
	scree_world* world;
	const char* function;
	const scree_mover_def* def;
	const scree_mover* before;
	scree_mover* after;
	int count;
	float force, dt; // N: maximum force of a mover; s
} PushCall;

typedef struct // impulses on bodies, one entry per pushed collidable
{
	scree_body* bodies;
	scree_vec *impulses, *points; // N s, m
	int count;
	void* memory; // released by the caller
} MoverPushes;

// Returns the velocity that a mover had before the call, relative to its ground, m/s. A mover on ground does not fall.
scree_vec mover_wish(const scree_mover_def* def, const scree_mover* before, const scree_world* world);

// Computes the impulses of all movers, and gives movers the speed of the bodies that they push. Changes no body.
scree_status mover_pushes(const PushCall* call, MoverPushes* pushes);

#endif
