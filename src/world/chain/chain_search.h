// SPDX-License-Identifier: MIT
// chain_search.h -- what the searches for chains and for branches share.
#ifndef CHAIN_SEARCH_H
#define CHAIN_SEARCH_H
#include "world/chain/chain_layout.h"
#include "world/world.h"
#include <math.h>

// Masses that are solved together differ by no more. Beyond it the large inverse masses leave no digit of the small ones in the
// sums of the solver, and impulses are wrong by any factor. Such joints are solved one by one: they yield, but stay finite.
#define MOST_RATIO 1e5f

#define BODY_OWNED    1 // at the end of a chain
#define BODY_BRANCHED 2 // in a branch
#define BODY_IN_TREE  4 // what hangs together with it makes a tree, or does not
#define BODY_IN_NET   8

typedef struct
{
	const scree_world* world;
	ChainLayout layout;
	uint8_t* seen;  // of each joint: in a chain or a branch, or found to be in none
	uint8_t* marks; // of each body, BODY_*
	int joints;     // of all chains
} ChainSearch;

// Whether a joint has a lock, and bodies that it can act on. Couplings hold no frames together; the axes of a path turn while the
// systems of chains have theirs.
bool chain_acts(const scree_world* world, int joint);

static inline int chain_other_body(const scree_world* world, int joint, int body)
{
	const int* bodies = world->host_joints[joint].bodies;
	return bodies[0] == body ? bodies[1] : bodies[0];
}

static inline bool chain_moves(const scree_world* world, int body)
{
	return world->host_bodies[body].type == SCREE_BODY_DYNAMIC;
}

// The lightest and the heaviest of the bodies that move.
typedef struct
{
	float least, most; // kg
} MassRange;

static inline MassRange mass_range(void) { return (MassRange){.least = INFINITY}; }

static inline void mass_range_add(MassRange* range, const scree_world* world, int body)
{
	float mass = world->host_bodies[body].mass.mass;
	if (!chain_moves(world, body))
		return;
	range->least = fminf(range->least, mass);
	range->most = fmaxf(range->most, mass);
}

static inline float mass_ratio(MassRange range) { return range.most / range.least; }

#endif
