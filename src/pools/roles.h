// SPDX-License-Identifier: MIT
// roles.h -- lists the kinds of items of pools, and the roles of pools: the lifetime of an item between two steps.
#ifndef ROLES_H
#define ROLES_H

typedef enum // kind of the items of a pool
{
	PER_ATTRIBUTE,
	PER_COLLIDABLE,
	PER_BODY,
#define CONSTRAINT_KIND(kind, Kind, KIND) \
	PER_##KIND, PER_##KIND##_PLACE, PER_##KIND##_BLOCK, // edge; place of the rows of a constraint; block of places
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	PER_BODY_GROUP,       // GROUP_ITEMS adjacent bodies
	PER_COLLIDABLE_GROUP, // GROUP_ITEMS adjacent collidables
	PER_CONTACT_GROUP,    // GROUP_ITEMS adjacent contacts
	PER_EDGE,             // edge of any kind
	PER_JOINED,           // pair of bodies that never touch
	PER_EXCLUDED,         // pair of bodies that the user keeps from touching
	PER_JOINT_EDIT,       // joint that the user created or changed
	PER_PATH_SAMPLE,      // sample of a path
	PER_CHAIN,            // joints that are solved together
	PER_CHAIN_BLOCK,      // MAX_LANES spots of a chain
	PER_BRANCH,           // body of a branch
	PER_SPOKE,            // contact of a hub
	PER_SPOKE_BLOCK,      // MAX_LANES contacts of hubs
	PER_RENDER_ROW,       // collidable in the render rows
	PER_CONTACT_REPORT,   // contact in a contact report
	PER_JOINT_REPORT,     // joint in a report of joints
	PER_EVENT,            // contact of a world in which some collidable reports events
	PER_APPROVAL,         // contact of a world with contact approval or one-way platforms
	PER_ALLOWED,          // pair of collidables that the user approved
	PER_STOPPED,          // body of a world with contact approval
	PER_QUERY_LEAF,       // leaf for queries
	PER_QUERY_NODE,       // node for queries
	PER_QUERY,
	PER_FOUND,         // result of a query
	PER_MATERIAL_PAIR, // pair of materials
	PER_FIELD,
	PER_FIELD_SPOT,  // state of a field in a step; in a batch, one in each world
	PER_FIELD_SHAPE, // collidable of a world with fields that act on shapes
	PER_TREE,
	PER_LEAF,
	PER_NODE,
	PER_NODE_GROUP, // ARITY adjacent nodes
	PER_KEY,
	PER_COMMAND,
	PER_HASH,
	PER_SAVED, // 16 bytes of a save
	PER_BAY,   // bay of a world of a batch
	PER_VISIT, // word of the list of visits to the sensors of a world of a batch
	PER_CHANNEL,
	PER_COLUMN, // float of a row of the inputs or outputs of a world of a batch
	PER_ONE,
	PER_COUNT
} Per;

typedef enum // lifetime of an item; the first three roles outlive a step, and migration copies them to the other device
{
	HASHED,   // included in the world hash; zero in a new item, until its writer sets it
	STATE,    // zero in a new item, until its writer sets it
	STANDING, // outlives a step; a new item is not cleared, but starts with the old content of its slot
	DERIVED,  // outlives a step; not copied to another device, but computed there from other pools
	SCRATCH,  // written before it is read in every step; undefined between steps
} Role;

#endif
