// SPDX-License-Identifier: MIT
// roles.h -- what a pool has an item for, and what becomes of an item between two steps.
#ifndef ROLES_H
#define ROLES_H

typedef enum // what a pool has an item for
{
	PER_ATTRIBUTE,
	PER_COLLIDABLE,
	PER_BODY,
#define CONSTRAINT_KIND(kind, Kind, KIND) \
	PER_##KIND, PER_##KIND##_PLACE, PER_##KIND##_BLOCK, // edge of a constraint; place of its rows; MAX_LANES of these
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	PER_EDGE,           // of any kind
	PER_JOINED,         // pair of bodies that never touch
	PER_EXCLUDED,       // of those, pair that the user set
	PER_JOINT_EDIT,     // joint that the user made or changed
	PER_PATH_SAMPLE,    // sample of a path
	PER_CHAIN,          // joints that are solved together
	PER_CHAIN_BLOCK,    // MAX_LANES spots of a chain
	PER_BRANCH,         // body of a branch
	PER_SPOKE,          // contact of a hub
	PER_SPOKE_BLOCK,    // of MAX_LANES of them
	PER_RENDER_ROW,     // collidable, as a renderer sees it
	PER_CONTACT_REPORT, // contact of a body that the user asks for
	PER_EVENT,          // contact of a world in which some collidable reports
	PER_APPROVAL,       // contact of a world in which some collidable asks, or is a one-way platform
	PER_ALLOWED,        // pair of collidables that may touch
	PER_STOPPED,        // body of a world in which some collidable asks
	PER_QUERY_LEAF,     // leaf, as queries see it
	PER_QUERY_NODE,     // node, as queries see it
	PER_QUERY,
	PER_FOUND,         // answer of a query
	PER_MATERIAL_PAIR, // pair of materials
	PER_FIELD,
	PER_FIELD_SHAPE, // collidable of a world with fields that act on shapes
	PER_TREE,
	PER_LEAF,
	PER_NODE,
	PER_NODE_GROUP, // ARITY nodes in a row
	PER_KEY,
	PER_COMMAND,
	PER_HASH,
	PER_ONE,
	PER_COUNT
} Per;

typedef enum // the first three outlive a step, and are copied to another device
{
	HASHED,   // in the world hash; zero in a new item, until its maker writes it
	STATE,    // zero in a new item, until its maker writes it
	STANDING, // a new item takes over what its slot holds
	DERIVED,  // outlives a step; computed from the others on another device
	SCRATCH,  // written before it is read in every step; undefined between steps
} Role;

#endif
