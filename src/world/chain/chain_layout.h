// SPDX-License-Identifier: MIT
// chain_layout.h -- places the joints of chains in device memory: a chain alone in rows, or chains side by side.
#ifndef CHAIN_LAYOUT_H
#define CHAIN_LAYOUT_H
#include "pools/pools.h"

typedef struct // a chain
{
	int first, count; // range of its joints in ChainLayout.joints
	int carried;      // 1 for a short chain with heavy bodies between two light ends
	int bits, cost;   // for the chain placed alone: log2 of the number of rows, and cost of a pass; set by chain_layout
} ChainRow;

typedef struct
{
	int* joints;       // joints of all chains, in order
	ChainRow* rows;    // chains, which chain_layout sorts
	int count;         // number of chains
	BranchNode* nodes; // nodes of all branches; the nodes of one branch are adjacent
	int* node_joints;  // joint of each node toward the root, -1 for none
	ChainRow* branches;
	int branch_count, node_count;
	// results
	ChainRange* ranges;        // at most one per chain and one per branch
	int* spots;                // spot of each joint of the world; unchanged for joints in no chain or branch
	int ranged, items, places; // number of ranges, number of items of a pass over chains, number of spots with padding
	int carried;               // index of the first item that has carried chains
} ChainLayout;

// Assigns spots for a device with `lanes` lanes and `groups` work-groups. The numbers in the results must be 0 before.
void chain_layout(ChainLayout* layout, int lanes, int groups);

#endif
