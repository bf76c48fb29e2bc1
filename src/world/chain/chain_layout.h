// SPDX-License-Identifier: MIT
// chain_layout.h -- where the joints of chains lie on a device: chains alone in rows, or side by side.
#ifndef CHAIN_LAYOUT_H
#define CHAIN_LAYOUT_H
#include "pools/pools.h"

typedef struct // a chain
{
	int first, count; // in ChainLayout.joints
	int carried;      // 1: a short one that is heavy between light ends
	int bits, cost;   // chain_layout's: of the number of rows that it has alone, and what a pass takes then
} ChainRow;

typedef struct
{
	int* joints;       // of all chains, in order
	ChainRow* rows;    // will be sorted
	int count;         // chains
	BranchNode* nodes; // of all branches; a row of them for each
	int* node_joints;  // of each, -1 for none
	ChainRow* branches;
	int branch_count, node_count;
	// results
	ChainRange* ranges;        // as many as there are chains, at most
	int* spots;                // of each joint of the world; those of no chain are left alone
	int ranged, items, places; // ranges, items of a pass over chains, spots with padding
	int carried;               // the first item of chains that are carried
} ChainLayout;

// Gives spots to the joints of all chains, for a device of so many lanes that has so many work-groups at the same time. ranged,
// items and places must be zero.
void chain_layout(ChainLayout* layout, int lanes, int groups);

#endif
