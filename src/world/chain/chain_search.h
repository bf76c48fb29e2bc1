// SPDX-License-Identifier: MIT
// chain_search.h -- defines the common parts of the searches for chains and for branches.
#ifndef CHAIN_SEARCH_H
#define CHAIN_SEARCH_H
#include "world/chain/chain_layout.h"
#include "world/world.h"
#include <math.h>

// Maximum ratio of the masses of bodies whose joints are solved together. With a larger ratio, the sum of two inverse
// masses keeps no digit of the smaller one, and impulses are wrong by any factor. If solved one by one, joints yield,
// but stay finite.
#define MOST_RATIO 1e5f

#define BODY_OWNED    1 // the body is at the end of a chain, even if that chain was then not used
#define BODY_BRANCHED 2 // the body is in a branch
#define BODY_IN_TREE  4 // the joints connected to the body form a tree
#define BODY_IN_NET   8 // the joints connected to the body form no tree

typedef struct
{
	const scree_world* world;
	ChainLayout layout;
	uint8_t* seen;  // per joint: 1 after the search has decided whether the joint is in a chain or a branch
	uint8_t* marks; // per body: BODY_* flags
	int joints;     // number of joints in all chains found so far
} ChainSearch;

// Returns whether a joint may be in a chain or branch: it is active, has a lock, and has a dynamic body. Excludes
// couplings, which do not hold frames together, and joints on paths: a chain's equations have fixed axes, but those of
// a path turn.
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

typedef struct // masses of the lightest and the heaviest movable body
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
