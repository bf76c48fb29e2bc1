// SPDX-License-Identifier: MIT
// chain_layout.h -- places the joints of chains in device memory: a chain alone in rows, or several side by side.
#ifndef CHAIN_LAYOUT_H
#define CHAIN_LAYOUT_H
#include "pools/pools.h"

typedef struct // a chain
{
	int first, count; // range of its joints in ChainLayout.joints
	int carried;      // 1: short chain; none of its bodies is between two bodies with LEAST_RATIO times its mass
	int bits, cost;   // for the chain placed alone: log2 of the number of rows, and cost of a pass; set by chain_layout
} ChainRow;

typedef struct
{
	int* joints;       // joints of all chains, one chain after the other
	ChainRow* rows;    // all chains; chain_layout sorts them
	int count;         // number of chains
	BranchNode* nodes; // nodes of all branches; the nodes of one branch are adjacent
	int* node_joints;  // per node: joint toward the root, -1 for none
	ChainRow* branches;
	int branch_count, node_count;
	// results
	ChainRange* ranges;        // at most one per chain and one per branch
	int* spots;                // spot of each joint of the world; unchanged for joints in no chain or branch
	int ranged, items, places; // number of ranges, number of items of a pass over chains, number of spots with padding
	int carried;               // index of the first item with carried chains; all later items have carried chains too
} ChainLayout;

// Assigns spots for a device with `lanes` lanes and `groups` work-groups. The caller has set the results' numbers to 0.
void chain_layout(ChainLayout* layout, int lanes, int groups);

#endif
