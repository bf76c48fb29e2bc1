// SPDX-License-Identifier: MIT
// chain_layout.c -- places the joints of chains in device memory: a chain alone in several rows, or several chains side
// by side. One worker solves chains of similar lengths faster side by side, one per lane. With more workers than
// chains, chains alone are faster, because each worker gets a chain. The layout with the lower estimated cost is used.
#include "world/chain/chain_layout.h"
#include "backend/backend.h"
#include "platform/threads.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

// Costs of a pass over a block of joints, one per lane: of a chain alone, and of chains side by side. The unit is the
// cost of one joint solved alone. Measured on CPUs with 16 and 8 lanes.
#define ROW_COST  12
#define SIDE_COST 8
#define APART     0.9 // separate blocks are used if the cost is less than this fraction of that with common blocks
// All chains are placed alone if the cost is less than this fraction of the cost with chains side by side. The fraction
// is below 1 because the workers in a pass wait for each other, which the estimated costs do not include.
#define ALONE 0.75

typedef struct
{
	ChainLayout* layout;
	int lanes, groups;
	bool alone; // true: all chains are placed alone
	int parts;  // maximum number of ranges in a block
	// latest block with chains side by side: first spot, number of spots from joint 0 to joint 1, number of ranges
	int column, column_odds, column_parts;
} ChainPlacement;

static int padded(int count, int lanes) { return (count + lanes - 1) / lanes * lanes; }

static int row_length(int joints, int bits) { return ((joints - 1) >> bits) + 1; }

// Chooses the number of rows with which a chain placed alone has the lowest cost. Sets row->bits and row->cost.
static void choose_rows(ChainRow* row, int lanes)
{
	for (int bits = 1; bits == 1 || (lanes > 1 && 1 << bits <= row->count); ++bits)
	{
		int length = row_length(row->count, bits);
		int cost = (ROW_COST << bits) * padded(length, lanes) / lanes + length;
		if (bits > 1 && cost >= row->cost)
			continue;
		row->bits = bits;
		row->cost = cost;
	}
}

// Returns the number of chains from chain k on to place side by side: at most one per lane, or 1 if they cost less
// alone. Sets *cost to their cost: side by side, they cost as much as the first chain, which is the longest.
static int side_by_side(const ChainPlacement* s, int k, int* cost)
{
	const ChainLayout* layout = s->layout;
	int alone = 0, count = 0, side = SIDE_COST * layout->rows[k].count;
	for (; !s->alone && k + count < layout->count && count < s->lanes &&
	       layout->rows[k + count].carried == layout->rows[k].carried;
	     ++count)
		alone += layout->rows[k + count].cost;
	count = alone > side ? count : 1;
	*cost = count > 1 ? side : layout->rows[k].cost;
	return count;
}

// Returns whether chains k to k + count - 1 begin an item of a pass. Otherwise they share the blocks of earlier chains.
static bool begins_item(ChainPlacement* s, int k, int count)
{
	const ChainRow* rows = s->layout->rows;
	bool shares = count > 1 && s->column_parts < s->parts && rows[k].carried == rows[k - 1].carried;
	s->column_parts = shares ? s->column_parts + 1 : count > 1 ? 1 : s->parts;
	return !shares;
}

// Returns the cost of a pass over all chains: that of the worker with the most work. With more than MAX_WORKERS
// work-groups, returns the mean cost per work-group, or the cost of the most expensive item if it is higher.
static double cost_of_all(ChainPlacement* s)
{
	double loads[MAX_WORKERS] = {0}, sum = 0, most = 0, item = 0;
	int counted = s->groups < MAX_WORKERS ? s->groups : MAX_WORKERS, items = 0;
	s->column_parts = s->parts;
	for (int k = 0, cost; k < s->layout->count;)
	{
		int count = side_by_side(s, k, &cost);
		bool begins = begins_item(s, k, count);
		items += begins;
		item = begins ? cost : item + cost;
		double* load = loads + dealt((items - 1) / counted, (items - 1) % counted, counted);
		*load += cost;
		sum += cost;
		most = fmax(most, s->groups > counted ? item : *load);
		k += count;
	}
	return s->groups > counted ? fmax(sum / s->groups, most) : most;
}

// Chooses the maximum number of ranges in a block: one or all that fit. Returns the cost of a pass. A block has one
// worker, as two would write to the same cache lines. Separate blocks take more memory, but distribute work better.
static double choose_parts(ChainPlacement* s)
{
	int most = s->parts;
	double together = cost_of_all(s);
	s->parts = 1;
	double apart = cost_of_all(s);
	if (apart < APART * together)
		return apart;
	s->parts = most;
	return together;
}

static ChainRange place_alone(ChainPlacement* s, const ChainRow* row)
{
	int length = padded(row_length(row->count, row->bits), s->lanes);
	ChainRange at = {s->layout->places, row->count, length << row->bits >> 1, 1, length, row->bits, 0, 0};
	s->layout->places += padded(2 * at.odds, MAX_LANES);
	return at;
}

// Places chains side by side, and returns their range. count: number of joints of the longest chain. If `begins` is
// false, uses free columns of the latest block, whose chains are at least as long, because chains are sorted by length.
static ChainRange place_side(ChainPlacement* s, int count, bool begins)
{
	int length = (count + 1) / 2;
	if (begins)
	{
		s->column = s->layout->places;
		s->column_odds = length * MAX_LANES;
		s->layout->places += 2 * s->column_odds;
	}
	int first = s->column + (s->column_parts - 1) * s->lanes;
	return (ChainRange){first, count, s->column_odds, MAX_LANES, length, 1, 0, 0};
}

// Orders chains: carried chains last, longer chains first, and chains of equal length in the order of discovery.
static int compare_rows(const void* a, const void* b)
{
	const ChainRow *first = a, *second = b;
	if (first->carried != second->carried)
		return first->carried - second->carried;
	return first->count != second->count ? second->count - first->count : first->first - second->first;
}

void chain_layout(ChainLayout* layout, int lanes, int groups)
{
	ChainPlacement s = {.layout = layout, .lanes = lanes, .groups = groups, .parts = MAX_LANES / lanes};
	for (int k = 0; k < layout->count; ++k)
		choose_rows(layout->rows + k, lanes);
	qsort(layout->rows, (size_t)layout->count, sizeof *layout->rows, compare_rows);
	double least = choose_parts(&s);
	s.alone = true;
	s.alone = cost_of_all(&s) < ALONE * least;
	s.column_parts = s.parts;
	for (int k = 0, count, cost, first = 0; k < layout->count; k += count)
	{
		const ChainRow* row = layout->rows + k;
		count = side_by_side(&s, k, &cost);
		bool begins = begins_item(&s, k, count);
		ChainRange at = count > 1 ? place_side(&s, row->count, begins) : place_alone(&s, row);
		for (int c = 0; c < count; ++c)
			for (int n = 0; n < row[c].count; ++n)
				layout->spots[layout->joints[row[c].first + n]] = c + CHAIN_SPOT(&at, n);
		first = begins ? layout->ranged : first;
		layout->carried += begins && !row->carried;
		layout->ranges[layout->ranged++] = at;
		++layout->ranges[first].parts;
		if (begins)
			layout->ranges[layout->items++].item = first;
	}
	for (int k = 0; k < layout->branch_count; ++k)
	{
		// a branch has one row, and blocks of its own
		const ChainRow* branch = layout->branches + k;
		ChainRange at = {
		    .first = layout->places, .count = branch->count, .odds = branch->first, .stride = 1, .parts = 1};
		for (int n = 0; n < branch->count; ++n)
		{
			int joint = layout->node_joints[branch->first + n];
			if (joint >= 0)
				layout->spots[joint] = at.first + n;
		}
		layout->places += padded(branch->count, MAX_LANES);
		layout->ranges[layout->ranged] = at;
		layout->ranges[layout->items + k].item = layout->ranged++;
	}
}
