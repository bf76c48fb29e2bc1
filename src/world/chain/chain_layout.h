// SPDX-License-Identifier: MIT
// chain_layout.h -- places the joints of chains in the memory of a device: a chain alone in rows, or side by side.
#ifndef CHAIN_LAYOUT_H
#define CHAIN_LAYOUT_H
#include "pools/pools.h"

typedef struct // a chain
{
	int first, count; // joints in ChainLayout.joints
	int carried;      // 1 for a short chain that is heavy between light ends
	int bits, cost;   // set by chain_layout for the chain alone: log2 of its number of rows, and the cost of a pass
} ChainRow;

typedef struct
{
	int* joints;       // joints of all chains, in order
	ChainRow* rows;    // one per chain; chain_layout sorts them
	int count;         // number of chains
	BranchNode* nodes; // nodes of all branches, a row per branch
	int* node_joints;  // joint of each node, -1 for none
	ChainRow* branches;
	int branch_count, node_count;
	// results
	ChainRange* ranges;        // at most one per chain and one per branch
	int* spots;                // per joint of the world: its spot; unchanged for joints of no chain or branch
	int ranged, items, places; // number of ranges, items of a pass over chains, spots with padding
	int carried;               // first item of carried chains
} ChainLayout;

// Assigns spots to the joints of all chains, for a device's lanes and work-groups. ranged, items and places are zero.
void chain_layout(ChainLayout* layout, int lanes, int groups);

#endif
